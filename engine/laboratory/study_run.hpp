#pragma once
#include <cstdint>
#include <vector>

#include "graph/rve_law.hpp"
#include "laboratory/study_history.hpp"
#include "scene/scene.hpp"

namespace sandgraph::laboratory {

// A packing to study.
struct StudySample {
    graph::RowPacking row;
    dem::Material material;
};

// The dense packing of `grains` at the isotropic stress `pressure` [Pa], from the packing cache if it is
// there.
StudySample study_sample(const scene::Grains& grains, double pressure);

// What came of one history under one setting.
struct StudyRun {
    std::vector<Stress> stress;  // after each increment
    std::int64_t dem_steps = 0, updates = 0, failures = 0;
    double seconds = 0;  // wall time
};

// One point behind graph::RveLaw, as a run drives it: skipping, allowance and substepping take part.
StudyRun run_history(const StudySample& sample, const StrainHistory& history,
                     const graph::RveSettings& stepping);

}  // namespace sandgraph::laboratory
