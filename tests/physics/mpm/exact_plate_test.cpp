#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"

namespace sandgraph::simulation {
namespace {

// A smooth plate pulled out of associated Mohr-Coulomb ground, phi = 30 deg, H/B = 3: N = 1 + (H/B) tan(phi).
double breakout_factor(const std::vector<std::string>& set) {
    const scene::Scene scene = scene::parse_scene(R"(
[domain]
width = "3.2 m"
depth = "4.4 m"
cell  = "0.2 m"
[anchor]
thickness = "0.2 m"
friction_angle = "0 deg"
pull_to = 0.02
[ground]
law = "mohr_coulomb"
[continuum]
young = "40 MPa"
friction_angle = "30 deg"
dilation_angle = "30 deg"
)",
                                                  "s.toml", set);
    const packings::PreparedGround ground = packings::prepare_ground(scene);
    const auto simulation = simulation_of(scene, ground);
    double sum = 0, count = 0;
    while (simulation->d_over_B() < 0.02) {
        simulation->step();
        if (simulation->d_over_B() > 0.015) sum += simulation->load(), count += 1;
    }
    return whole_plate_factor(scene) * sum / count / unit_load(scene, ground);
}

const double kExact = 1 + 3 * std::tan(std::numbers::pi / 6);

TEST(ExactPlate, IsMetWithFiveCellsAWidth) {
    EXPECT_NEAR(breakout_factor({}) / kExact, 1, 0.02);
    EXPECT_NEAR(breakout_factor({"domain.points_per_cell=4"}) / kExact, 1, 0.02);
}

// What the paper's transfer makes of the same: four points a cell lock, and a plate with its ends on nodes is
// a cell too wide.
TEST(ExactPlate, IsMissedByLockedCellsAndEndsOnNodes) {
    EXPECT_GT(breakout_factor({"domain.points_per_cell=4", "mpm.hourglass=1"}) / kExact, 1.06);
    EXPECT_GT(breakout_factor({"domain.cell=0.1 m", "domain.edges=on_nodes"}) / kExact, 1.03);
}

}  // namespace
}  // namespace sandgraph::simulation
