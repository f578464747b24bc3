#pragma once
#include <optional>
#include <string>
#include <vector>

#include "results/compare_runs.hpp"
#include "results/run_scene.hpp"

namespace sandgraph::results {

struct ParetoRequest {
    simulation::RunRequest run;  // `folder` holds all runs
    // gate.strain, or gate.strain:gate.flow; all grains and all surrogate are always there
    std::vector<std::string> thresholds;
    DrawPictures draw;
    bool census = false;  // each again with every point audited: the true stress error
};

struct ParetoRow {
    std::string label;  // "full", the threshold, or "surrogate"
    Comparison against;
    double wall = 0, cpu = 0;  // [s]
    std::int64_t dem_steps = 0;
    double true_error = 0;
};

// Runs the scene at full fidelity and at each threshold, each in a folder of its own; a run that this
// program finished on as many threads is not repeated, one that was stopped goes on. Empty when a run was
// stopped again.
std::optional<std::vector<ParetoRow>> pareto_study(const ParetoRequest& request);

std::string to_csv(const std::vector<ParetoRow>& rows);

}  // namespace sandgraph::results
