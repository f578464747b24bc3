#include "app/study_run.hpp"

#include <fmt/format.h>

#include "app/live_line.hpp"
#include "app/packing_cache.hpp"
#include "app/prepare_packing.hpp"
#include "app/rve_options.hpp"
#include "dem/observe.hpp"

namespace sandgraph::app {
namespace {

graph::PlaneModuli moduli(const dem::Packing& packing, const dem::Material& material,
                          const std::string& recipe) {
    const auto value = cached_numbers(recipe, 2, [&] {
        const dem::Moduli m = dem::small_strain_moduli(packing, material, fast_assemblies());
        return std::vector<double>{m.bulk, m.shear};
    });
    return {value[0], value[1]};
}

}  // namespace

StudySample study_sample(const scene::Grains& grains, double pressure) {
    const dem::Material& material = grains.material;
    const std::string recipe = packing_recipe(grains);
    const dem::Packing base =
        cached_packing(recipe + "base\n", material, [&] { return base_packing(grains); });
    const dem::Packing packing = cached_packing(
        fmt::format("{}pressure = {:a}\n", recipe, pressure), material,
        [&] { return dem::compress_to(base, {.pressure = pressure}, material, fast_assemblies()); });
    const Mat2 stress = dem::love_weber_stress(packing, dem::contact_forces(packing, material), material);
    return {{dem::compact(packing, material, stress),
             moduli(packing, material, fmt::format("{}moduli at {:a}\n", recipe, pressure))},
            material,
            grains.radius_min};
}

StudyRun run_history(const StudySample& sample, const StrainHistory& history,
                     const scene::RveStepping& stepping) {
    graph::RveLaw law({sample.material,
                       rve_options(stepping, sample.material, sample.radius_min),
                       {sample.row},
                       {0},
                       stepping.update_tolerance,
                       stepping.update_change_max});
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

}  // namespace sandgraph::app
