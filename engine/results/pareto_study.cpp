#include "results/pareto_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "results/kept_run.hpp"

namespace sandgraph::results {
namespace {

namespace fs = std::filesystem;

struct Plan {
    std::string label;
    std::string mode;
    std::vector<std::string> set;
};

// "0.003" or "0.003:0.1".
std::vector<std::string> gate_of(const std::string& threshold) {
    const std::size_t colon = threshold.find(':');
    std::vector<std::string> set{"gate.strain=" + threshold.substr(0, colon)};
    if (colon != std::string::npos) set.push_back("gate.flow=" + threshold.substr(colon + 1));
    return set;
}

std::vector<Plan> plans(const ParetoRequest& request) {
    std::vector<Plan> out{{"full", "full", {}}};
    for (const std::string& t : request.thresholds) out.push_back({t, "screening", gate_of(t)});
    out.push_back({"surrogate", "screening", {"gate.active=false"}});
    return out;
}

// What the study itself varies cannot be given for all its runs.
void refuse_varied(const ParetoRequest& request) {
    const auto has_flow = [](const std::string& threshold) {
        return threshold.find(':') != std::string::npos;
    };
    const bool flow = std::ranges::any_of(request.thresholds, has_flow);
    for (const std::string& assignment : request.run.set) {
        const std::string_view key = trimmed(std::string_view(assignment).substr(0, assignment.find('=')));
        if (key == "mode" || key == "gate.active" || key == "gate.strain" || (flow && key == "gate.flow"))
            throw InputError({"--set", 0}, assignment, "the study varies it from run to run",
                             "leave it out; --thresholds are the values of gate.strain and gate.flow");
    }
}

// A study's settings of the surrogate are for the runs that have one, those of the gate for those with a
// gate.
void drop_idle(std::vector<std::string>& set, const Plan& plan) {
    const auto idle = [&plan](const std::string& assignment) {
        const auto of = [&assignment](const char* table) { return trimmed(assignment).starts_with(table); };
        if (plan.mode == "full") return of("surrogate.") || of("gate.") || of("audit.");
        return plan.label == "surrogate" && of("gate.");
    };
    std::erase_if(set, idle);
}

simulation::RunRequest run_request(const ParetoRequest& request, const Plan& plan) {
    simulation::RunRequest run = request.run;
    run.mode = plan.mode;
    drop_idle(run.set, plan);
    run.set.insert(run.set.end(), plan.set.begin(), plan.set.end());
    return run;
}

// The run of a plan, made now unless its folder has it.
std::optional<FinishedRun> run_of(const ParetoRequest& request, const Plan& plan, const std::string& suffix) {
    simulation::RunRequest run = run_request(request, plan);
    if (!suffix.empty()) run.set.emplace_back("audit.share=1");
    run.folder = (fs::path(request.run.folder) / (plan.label + suffix)).string();
    return kept_run(run, request.draw);
}

}  // namespace

std::optional<std::vector<ParetoRow>> pareto_study(const ParetoRequest& request) {
    refuse_varied(request);
    for (const Plan& plan : plans(request))
        simulation::scene_of(run_request(request, plan));  // refused before any runs
    std::vector<ParetoRow> rows;
    std::optional<FinishedRun> reference;
    for (const Plan& plan : plans(request)) {
        const auto run = run_of(request, plan, "");
        if (!run) return std::nullopt;
        if (!reference) reference = run;
        ParetoRow row{plan.label,         compare_runs(*reference, *run), run->summary.wall_s,
                      run->summary.cpu_s, run->summary.dem_steps,         io::Summary::unknown};
        if (request.census && plan.mode == "screening") {
            const auto census = run_of(request, plan, "_census");
            if (!census) return std::nullopt;
            row.true_error = census->summary.audit.stress_error_mean;
        }
        rows.push_back(row);
    }
    return rows;
}

std::string to_csv(const std::vector<ParetoRow>& rows) {
    std::string out =
        "threshold,wall_s,cpu_s,speedup,cpu_ratio,dem_steps,dem_fraction_mean,dem_fraction_final,peak_error,"
        "peak_position_error,curve_error,curve_error_smoothed,displacement_error,stress_error,jump_p95,"
        "jump_felt_p95,ordinary_step_p95,replay_share,audit_mean,audit_ci95,true_stress_error,interval_"
        "holds\n";
    for (const ParetoRow& r : rows) {
        const Comparison& c = r.against;
        const bool known = std::isfinite(r.true_error) && std::isfinite(c.audit_ci95);
        out += fmt::format("{},{:.2f},{:.2f},{:.3f},{:.3f},{},{:.4f},{:.4f},", r.label, r.wall, r.cpu,
                           c.wall_ratio, c.cpu_ratio, r.dem_steps, c.dem_share_mean, c.dem_share);
        out += fmt::format("{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},", c.peak_error, c.peak_position_error,
                           c.curve_error, c.curve_error_smoothed, c.displacement_error, c.stress_error);
        out +=
            fmt::format("{:.4f},{:.5f},{:.5f},{:.4f},{:.5f},{:.5f},{:.5f},{}\n", c.jump_p95, c.felt_p95,
                        c.ordinary_p95, c.replay_share, c.audit_mean, c.audit_ci95, r.true_error,
                        known ? (std::abs(r.true_error - c.audit_mean) <= c.audit_ci95 ? "yes" : "no") : "");
    }
    return out;
}

}  // namespace sandgraph::results
