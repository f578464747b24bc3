#include <fmt/format.h>

#include <cmath>

#include "results/sweep_results.hpp"

namespace sandgraph::results {
namespace {

using simulation::SweepPlan;

// What nobody can tell is an empty cell.
std::string cell(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

// A list has commas of its own.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string head(const SweepPlan& plan, const char* rest) {
    std::string text = "row";
    for (const std::string& key : plan.table.keys) text += "," + key;
    return text + rest;
}

std::string varied(const SweepPlan& plan, std::size_t row) {
    std::string text = plan.table.rows[row].name;
    for (const scene::SweepValue& value : plan.table.rows[row].values)
        text += fmt::format(",{}", cell(value.text));
    return text;
}

std::string line_of(const SweepRowResult& r) {
    std::string text = fmt::format(",{},{},{}", r.samples.size(), r.finished, r.n_gamma.count);
    for (const double value : {r.n_gamma.mean, r.n_gamma.ci95, r.n_gamma.deviation})
        text += fmt::format(",{}", cell(value));
    for (const double value : r.quantiles) text += fmt::format(",{}", cell(value));
    for (const double value : {r.formula, r.peak, r.d_over_B, r.late})
        text += fmt::format(",{}", cell(value));
    text += fmt::format(",{},{}", r.warnings, r.audit_points);
    return text + fmt::format(",{},{},{:.2f},{},{}\n", cell(r.audit_error), cell(r.audit_ci95), r.cpu,
                              r.dem_steps, state_word(r.state));
}

std::string line_of(const SweepSample& s) {
    const std::string seed = std::to_string(s.run->scene.ground.grains.seed);
    std::string text = fmt::format(",{},{},{}", s.run->sample, seed, state_word(s.state));
    const io::Summary none, &m = s.summary ? *s.summary : none;
    for (const double value : {s.summary && m.breakout ? m.n_gamma : io::Summary::unknown, m.breakout_load,
                               m.breakout_d_over_B, m.late_load, m.audit.stress_error_mean, m.audit.ci95})
        text += fmt::format(",{}", cell(value));
    return text + fmt::format(",{},{:.2f},{},{}\n", m.warnings.size(), m.cpu_s, m.dem_steps, cell(s.failure));
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.3f}", value) : "-"; }

}  // namespace

std::string sweep_table_csv(const SweepPlan& plan, const std::vector<SweepRowResult>& rows) {
    std::string out = head(
        plan,
        ",samples,finished,breakouts,n_gamma,n_gamma_ci95,n_gamma_sd,n_gamma_p05,n_gamma_p50,n_gamma_p95,"
        "n_gamma_formula,peak_load_N_per_m,peak_d_over_B,late_load_N_per_m,warnings,audit_points,"
        "audit_stress_error_mean,audit_ci95,cpu_s,dem_steps,status\n");
    for (std::size_t k = 0; k < rows.size(); ++k) out += varied(plan, k) + line_of(rows[k]);
    return out;
}

std::string sweep_samples_csv(const SweepPlan& plan, const std::vector<SweepRowResult>& rows) {
    std::string out = head(plan,
                           ",sample,seed,status,n_gamma,peak_load_N_per_m,peak_d_over_B,late_load_N_per_m,"
                           "audit_stress_error_mean,audit_ci95,warnings,cpu_s,dem_steps,failure\n");
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (const SweepSample& sample : rows[k].samples) out += varied(plan, k) + line_of(sample);
    return out;
}

std::string sweep_text(const SweepPlan& plan, const std::vector<SweepRowResult>& rows) {
    std::string out;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const SweepRowResult& r = rows[k];
        out += fmt::format("{}: N {}", plan.table.rows[k].name, number(r.n_gamma.mean));
        if (std::isfinite(r.n_gamma.ci95))
            out += fmt::format(" ± {}, deviation {}, quantiles {} {} {}", number(r.n_gamma.ci95),
                               number(r.n_gamma.deviation), number(r.quantiles[0]), number(r.quantiles[1]),
                               number(r.quantiles[2]));
        out += r.state == simulation::RunState::finished
                   ? "\n"
                   : fmt::format(" ({} of {} finished, {})\n", r.finished, r.samples.size(),
                                 state_word(r.state));
    }
    return out;
}

}  // namespace sandgraph::results
