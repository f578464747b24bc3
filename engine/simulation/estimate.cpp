#include "simulation/estimate.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/process.hpp"
#include "scene/alignment.hpp"
#include "scene/expected_ground.hpp"
#include "simulation/programme.hpp"

namespace sandgraph::simulation {
namespace {

// Measured on 2 cores of 2025, packings of Table 1.
constexpr double kBytesAPoint = 1000;      // its row of the state, grid and outputs included
constexpr double kBytesAGrain = 62;        // of a packing of its own
constexpr double kScreenedShare = 0.4;     // of the points that get one in a screening run
constexpr double kPointStep = 60e-9;       // [s] of a core
constexpr double kGrainStep = 3e-6 / 400;  // [s] of a core, a DEM step by its grains
constexpr double kBasePacking = 5. / 400;  // [s] of a core, by its grains, its friction included
constexpr double kInSituPacking = 0.5 / 400;
constexpr double kDemSteps = 700, kDemStepsAWidth = 12'500;  // of a point: at rest, and a plate width of pull

bool of_grains(const scene::Scene& s) { return s.ground.law == scene::Law::rve; }
double packed_share(const scene::Scene& s) {
    if (!of_grains(s)) return 0;
    return s.mode == scene::Mode::screening ? kScreenedShare : 1;
}

// What is made before the first step: in-situ packings of every row and sample.
void add_preparation(const scene::Scene& s, int threads, Estimate& e) {
    if (!of_grains(s)) return;
    const scene::Grains& g = s.ground.grains;
    const double rows = s.domain.depth / scene::point_spacing(s.domain);
    e.packings = rows * g.samples;
    e.bytes += e.packings * kBytesAGrain * g.count;
    e.preparation = (g.samples * kBasePacking + e.packings * kInSituPacking) * g.count / threads;
}

double duration(const scene::Scene& s) {
    if (!s.loaded()) return s.mpm.end_time;
    return settling_time(s.anchor.width) +
           (s.anchor.pull_to + s.anchor.ramp) * s.anchor.width / s.anchor.pull_rate;
}

double step_of(const scene::Scene& s, double modulus) {
    return mpm::time_step(s.mpm, {s.domain.cell, modulus, scene::expected_density(s)});
}

}  // namespace

Estimate estimate(const scene::Scene& s, int threads) {
    const double spacing = scene::point_spacing(s.domain);
    Estimate e;
    e.points = s.domain.width * s.domain.depth / (spacing * spacing);
    e.steps = duration(s) / step_of(s, scene::expected_modulus(s));
    e.bytes = e.points * (kBytesAPoint + packed_share(s) * kBytesAGrain * s.ground.grains.count);
    const double pull = s.loaded() ? s.anchor.pull_to : 0;
    const double dem =
        packed_share(s) * (kDemSteps + kDemStepsAWidth * pull) * kGrainStep * s.ground.grains.count;
    e.seconds = e.points * (e.steps * kPointStep + dem) / threads;
    add_preparation(s, threads, e);
    return e;
}

void require_feasible(const scene::Scene& s, const Estimate& e) {
    const double memory = memory_limit();
    if (e.bytes > memory)
        throw InputError(
            {s.file, 0}, fmt::format("{:.2g} material points", e.points),
            fmt::format("they need {:.3g} GB{}, there is room for {:.3g}", e.bytes / 1e9,
                        of_grains(s) ? fmt::format(" with packings of {} grains", s.ground.grains.count) : "",
                        memory / 1e9),
            "look at domain.width, domain.depth and domain.cell");
    if (!s.loaded()) return;
    constexpr double stiffest =
        2;  // of packings, beside what is expected: the last word is said when they are made
    require_slow_plate(s, step_of(s, (of_grains(s) ? stiffest : 1) * scene::expected_modulus(s)));
}

void require_slow_plate(const scene::Scene& scene, double dt) {
    constexpr double most = 0.01;  // cells a step; the paper's rate takes 1e-4
    const double cells = scene.anchor.pull_rate * dt / scene.domain.cell;
    if (cells > most)
        throw InputError(scene.where("anchor.pull_rate"),
                         fmt::format("anchor.pull_rate = {:g} m/s", scene.anchor.pull_rate),
                         fmt::format("the plate would move {:.2g} cells in one step of {:.2g} s", cells, dt),
                         fmt::format("pull with {:.2g} m/s at most", most * scene.domain.cell / dt));
}

}  // namespace sandgraph::simulation
