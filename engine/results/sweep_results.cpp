#include "results/sweep_results.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "results/finished_run.hpp"

namespace sandgraph::results {
namespace {

using simulation::RunState;
using simulation::SweepRun;

std::string first_line(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

SweepSample sample_of_run(const SweepRun& run) {
    SweepSample sample;
    sample.run = &run, sample.state = simulation::state_of(run);
    if (sample.state == RunState::finished) sample.summary = io::read_summary(run.folder() / "summary.json");
    if (sample.state == RunState::failed) sample.failure = first_line(run.failure());
    return sample;
}

// Over the finished samples that know it.
double mean_of(const SweepRowResult& row, double (*value)(const io::Summary&)) {
    std::vector<double> values;
    for (const SweepSample& s : row.samples)
        if (s.summary && std::isfinite(value(*s.summary))) values.push_back(value(*s.summary));
    return sample_of(values).mean;
}

double formula_of(const SweepRowResult& row) {
    const scene::Scene& scene = row.samples.front().run->scene;
    if (!scene.anchor.present) return io::Summary::unknown;
    return pulled_up(scene) ? mean_of(row, [](const io::Summary& s) { return s.n_gamma_meyerhof_adams; })
                            : mean_of(row, [](const io::Summary& s) { return s.n_gamma_biarez; });
}

void add_loads(SweepRowResult& row) {
    const std::vector<double> factors = row.factors();
    row.n_gamma = sample_of(factors);
    for (std::size_t k = 0; k < sweep_quantiles.size(); ++k)
        row.quantiles[k] = quantile(factors, sweep_quantiles[k]);
    row.formula = formula_of(row);
    row.peak = mean_of(row, [](const io::Summary& s) { return s.breakout_load; });
    row.d_over_B = mean_of(row, [](const io::Summary& s) { return s.breakout_d_over_B; });
    row.late = mean_of(row, [](const io::Summary& s) { return s.late_load; });
    row.audit_error = mean_of(row, [](const io::Summary& s) { return s.audit.stress_error_mean; });
    row.audit_ci95 = mean_of(row, [](const io::Summary& s) { return s.audit.ci95; });
}

void add_counts(SweepRowResult& row) {
    row.state = RunState::finished;
    for (const SweepSample& s : row.samples) {
        if (s.state == RunState::failed || row.state == RunState::finished) row.state = s.state;
        if (s.state == RunState::stopped && row.state == RunState::waiting) row.state = s.state;
        if (!s.summary) continue;
        ++row.finished;
        row.warnings += s.summary->warnings.size();
        row.audit_points += s.summary->audit.points;
        row.cpu += s.summary->cpu_s;
        row.dem_steps += s.summary->dem_steps;
    }
}

}  // namespace

std::vector<double> SweepRowResult::factors() const {
    std::vector<double> values;
    for (const SweepSample& s : samples)
        if (s.summary && s.summary->breakout && std::isfinite(s.summary->n_gamma))
            values.push_back(s.summary->n_gamma);
    return values;
}

std::vector<SweepRowResult> sweep_results(const simulation::SweepPlan& plan) {
    std::vector<SweepRowResult> rows(plan.table.rows.size());
    for (const SweepRun& run : plan.runs) rows[run.row].samples.push_back(sample_of_run(run));
    for (SweepRowResult& row : rows) add_loads(row), add_counts(row);
    return rows;
}

const char* state_word(RunState state) {
    switch (state) {
        case RunState::waiting:
            return "waiting";
        case RunState::stopped:
            return "stopped";
        case RunState::failed:
            return "failed";
        case RunState::finished:
            break;
    }
    return "finished";
}

}  // namespace sandgraph::results
