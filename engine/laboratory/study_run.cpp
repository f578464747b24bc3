#include "laboratory/study_run.hpp"

#include "base/console.hpp"
#include "packings/compressed_packings.hpp"

namespace sandgraph::laboratory {
StudySample study_sample(const scene::Grains& grains, double pressure) {
    return {packings::CompressedPackings(grains).row(pressure), grains.material};
}

StudyRun run_history(const StudySample& sample, const StrainHistory& history,
                     const graph::RveSettings& stepping) {
    graph::RveLaw law({sample.material,
                       dem::rve_options(stepping, sample.material, sample.row.packing->grains->radius),
                       {sample.row},
                       {0},
                       stepping});
    std::vector<std::int32_t> point{0};
    std::vector<Mat2> F_inc{Mat2::Identity()};
    std::vector<Stress> stress(1);
    const stress::Batch batch{point, F_inc, stress, 0};
    law.initialise(batch);
    StudyRun run;
    run.stress.reserve(history.increments.size());
    const double start = wall_clock();
    for (const Mat2& increment : history.increments) {
        F_inc[0] = increment;
        law.update(batch);
        run.stress.push_back(stress[0]);
    }
    run.seconds = wall_clock() - start;
    const graph::RveCounters& c = law.counters();
    run.dem_steps = c.dem_steps, run.updates = c.updates, run.failures = c.failures;
    return run;
}

}  // namespace sandgraph::laboratory
