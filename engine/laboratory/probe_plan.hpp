#pragma once
#include "laboratory/probe_path.hpp"
#include "scene/probe_spec.hpp"

namespace sandgraph::laboratory {

// One packing of a probe; its row in the log is (density * seeds + seed) * pressures + pressure.
struct PackingPlan {
    scene::Grains grains;  // the recipe of its base packing
    double pressure = 0;   // [Pa]
};

// A history to drive, and the twins that repeat its strain. Their rows in the log follow each other.
struct ProbeJob {
    std::size_t first = 0;  // row of the history in `histories`; its twins come next
    std::size_t count = 1;  // with its twins
    ProbePath path;
};

// All that a recipe asks for, drawn by its seed.
struct ProbePlan {
    std::vector<PackingPlan> packings;
    std::vector<io::HistoryInfo> histories;
    std::vector<ProbeJob> jobs;
};
ProbePlan plan_probe(const scene::ProbeSpec& spec);

}  // namespace sandgraph::laboratory
