#include "results/screening_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/load_error.hpp"

namespace sandgraph::results {
namespace {

const std::string kSwitches = "switches ";  // + reason: a key of the summary

// Of those that are numbers.
double quantile(std::vector<double> values, double share) {
    std::erase_if(values, [](double v) { return std::isnan(v); });
    if (values.empty()) return io::Summary::unknown;
    const auto k = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
    return values[k];
}

void add_hand_over(const stress::ScreeningLog& log, io::Summary& s) {
    std::array<double, stress::reason_count> count{};
    std::vector<double> jumps, felt, ordinary;
    for (const stress::Switch& one : log.switches) {
        ++count[static_cast<std::size_t>(one.reason)];
        jumps.push_back(one.jump), felt.push_back(one.felt), ordinary.push_back(one.ordinary);
    }
    for (std::size_t r = 1; r < count.size(); ++r)
        s.extra.emplace_back(kSwitches + stress::reason_names[r], count[r]);
    s.extra.emplace_back("jump_p50", quantile(jumps, 0.5));
    s.extra.emplace_back("jump_p95", quantile(jumps, 0.95));
    s.extra.emplace_back("jump_max", quantile(jumps, 1));
    s.extra.emplace_back("jump_felt_p50", quantile(felt, 0.5));
    s.extra.emplace_back("jump_felt_p95", quantile(felt, 0.95));
    s.extra.emplace_back("ordinary_step_p50", quantile(ordinary, 0.5));
    s.extra.emplace_back("ordinary_step_p95", quantile(ordinary, 0.95));
    s.extra.emplace_back("jump_work_J_per_m", log.counters.jump_work);
}

std::string reasons(const io::Summary& s) {
    std::string out;
    for (const auto& [name, value] : s.extra)
        if (name.starts_with(kSwitches) && value > 0)
            out += fmt::format("{}{} {:.0f}", out.empty() ? "" : ", ", name.substr(kSwitches.size()), value);
    return out.empty() ? "none" : out;
}

std::string felt_text(const io::Summary& s) {
    std::string out =
        fmt::format("what the ground feels of it in one step: {:.2f} % (median), {:.2f} % (95th percentile)",
                    100 * s.number("jump_felt_p50"), 100 * s.number("jump_felt_p95"));
    if (s.number("ordinary_step_p95") >= 0)
        out += fmt::format("; the same points' largest step afterwards: {:.2f} %, {:.2f} %",
                           100 * s.number("ordinary_step_p50"), 100 * s.number("ordinary_step_p95"));
    return out + "\n";
}

}  // namespace

void add_screening(const stress::Law& law, std::size_t points, io::Summary& s) {
    const stress::ScreeningLog& log = *law.screening_log();
    const stress::ScreeningCounters& c = log.counters;
    const stress::GrainUse grains = law.grain_use();
    const auto n = static_cast<double>(points);
    s.surrogate_updates = c.surrogate_updates;
    s.dem_fraction_final = static_cast<double>(grains.active) / n;
    s.dem_fraction_mean = c.dem_points / std::max(1.0, static_cast<double>(c.steps)) / n;
    const stress::AuditRow audit = law.audit();
    s.audit.points = static_cast<std::int64_t>(audit.points);
    s.audit.stress_error_mean = audit.mean, s.audit.ci95 = audit.ci95;
    s.extra.emplace_back("rve_failures", static_cast<double>(grains.failures));
    s.extra.emplace_back("failed_answers", static_cast<double>(c.failed_answers));
    s.extra.emplace_back("dem_steps_replay", static_cast<double>(c.replay_steps));
    s.extra.emplace_back("dem_steps_shadow", static_cast<double>(c.shadow_steps));
    s.extra.emplace_back("dem_steps_audit", static_cast<double>(c.audit_steps));
    s.extra.emplace_back("dem_steps_load_audit", static_cast<double>(c.load_audit_steps));
    add_hand_over(log, s);
}

std::string screening_text(const io::Summary& s) {
    std::string out =
        fmt::format("grains answer for {:.1f} % of the points at the end, {:.1f} % on average\n",
                    100 * s.dem_fraction_final, 100 * s.dem_fraction_mean);
    out += fmt::format("handed over because of: {}\n", reasons(s));
    if (s.number("jump_p95") >= 0)
        out += fmt::format("stress jump at hand-over: {:.1f} % of p (median), {:.1f} % (95th percentile)\n",
                           100 * s.number("jump_p50"), 100 * s.number("jump_p95"));
    if (s.number("jump_felt_p95") >= 0) out += felt_text(s);
    if (s.audit.points > 0)
        out += fmt::format("audit: the surrogate's stress is off by {:.1f} +- {:.1f} % of p ({} point{})\n",
                           100 * s.audit.stress_error_mean, 100 * s.audit.ci95, s.audit.points,
                           s.audit.points == 1 ? "" : "s");
    out += load_error_text(s);
    if (const double failed = s.number("failed_answers"); failed > 0)
        out +=
            fmt::format("warning: the surrogate failed at {:.0f} points; their grains took over\n", failed);
    return out;
}

}  // namespace sandgraph::results
