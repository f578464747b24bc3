#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/statistics.hpp"
#include "io/summary.hpp"
#include "simulation/sweep_plan.hpp"

namespace sandgraph::results {

// One run of a sweep, as its folder tells.
struct SweepSample {
    const simulation::SweepRun* run = nullptr;
    simulation::RunState state = simulation::RunState::waiting;
    std::string failure;                 // of a failed one: a line
    std::optional<io::Summary> summary;  // of a finished one
};

inline constexpr std::array sweep_quantiles{0.05, 0.5, 0.95};

// A row: over its finished samples. NaN: nobody can tell.
struct SweepRowResult {
    std::vector<SweepSample> samples;
    std::size_t finished = 0;
    Sample n_gamma;  // of those that broke out
    std::array<double, sweep_quantiles.size()> quantiles{};
    double formula = io::Summary::unknown;  // N_gamma of the closed form of its plate
    double peak = io::Summary::unknown, d_over_B = io::Summary::unknown;  // means [N/m], -
    double late = io::Summary::unknown;                                   // [N/m]
    std::size_t warnings = 0;                                             // lines, of all samples
    std::int64_t audit_points = 0;
    double audit_error = io::Summary::unknown, audit_ci95 = io::Summary::unknown;  // means, shares of p
    double cpu = 0;                                                                // [s]
    std::int64_t dem_steps = 0;
    simulation::RunState state = simulation::RunState::waiting;  // the worst of its samples

    std::vector<double> factors() const;  // N_gamma of each that broke out
};

// What is there of a sweep, row by row. `plan` must outlive it.
std::vector<SweepRowResult> sweep_results(const simulation::SweepPlan& plan);

const char* state_word(simulation::RunState state);

// table.csv, a line a row, and samples.csv, a line a run (docs/file_formats.md).
std::string sweep_table_csv(const simulation::SweepPlan& plan, const std::vector<SweepRowResult>& rows);
std::string sweep_samples_csv(const simulation::SweepPlan& plan, const std::vector<SweepRowResult>& rows);

// A line a row, to read: N, its interval, and with more samples its deviation and quantiles.
std::string sweep_text(const simulation::SweepPlan& plan, const std::vector<SweepRowResult>& rows);

}  // namespace sandgraph::results
