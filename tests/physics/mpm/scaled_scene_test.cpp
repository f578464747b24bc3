#include <gtest/gtest.h>

#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"
#include "tests/support/sand_scene.hpp"

namespace sandgraph::simulation {
namespace {

// Lengths times s and gravity over s: the same stresses, the same wave speed, hence the same load in units of
// gamma H B. No length or time of the paper's scene may stand in the code.
std::string scene_of(double s) {
    return support::sand_scene({.width = 3 * s,
                                .depth = 4 * s,
                                .cell = 0.125 * s,
                                .plate = s,
                                .thickness = 0.125 * s,
                                .pull_to = 0.02,
                                .gravity = 9.81 / s});
}

std::vector<double> curve(double s) {
    const scene::Scene scene = scene::parse_scene(scene_of(s), "s.toml", {});
    const packings::PreparedGround ground = packings::prepare_ground(scene);
    const auto simulation = simulation_of(scene, ground);
    const double unit = unit_load(scene, ground) / whole_plate_factor(scene);
    std::vector<double> out;
    double sum = 0, next = 0.001;
    for (int n = 1; simulation->mark() < 0.02; ++n) {
        simulation->step();
        sum += simulation->load() / unit;
        if (simulation->mark() < next) continue;
        out.push_back(sum / n), next += 0.001, sum = 0, n = 0;
    }
    return out;
}

TEST(ScaledScene, GivesTheSameLoad) {
    const std::vector<double> one = curve(1);
    for (const double s : {0.01, 12.0}) {
        const std::vector<double> other = curve(s);
        ASSERT_EQ(other.size(), one.size());
        for (std::size_t k = 0; k < one.size(); ++k)
            EXPECT_NEAR(other[k] / one[k], 1, 0.005) << s << ' ' << k;
    }
}

// The room above the ground goes with the plate: a wide one lifts the ground by more than a metre.
TEST(ScaledScene, HasRoomForItsHeave) {
    const scene::Scene scene = scene::parse_scene(scene_of(12), "s.toml", {});
    const Spec spec = spec_of(scene, packings::prepare_ground(scene));
    EXPECT_GE(spec.grid.ny * spec.grid.cell,
              scene.domain.depth + (scene.anchor.pull_to + 1) * scene.anchor.width - 1e-9);
}

}  // namespace
}  // namespace sandgraph::simulation
