#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"

namespace sandgraph::simulation {
namespace {

scene::Scene pipe() {
    return scene::parse_scene(R"(
[domain]
width = "3 m"
depth = "4 m"
cell = "0.125 m"
[[body]]
shape = "circle"
centre = ["0 m", "1.5 m"]
radius = "0.5 m"
friction_angle = "0 deg"
velocity = ["0 m/s", "0.02 m/s"]
travel = "0.01 m"
[ground]
law = "mohr_coulomb"
[continuum]
young = "80 MPa"
friction_angle = "30 deg"
dilation_angle = "30 deg"
)",
                              "s.toml");
}

// Blocks of sand between planes 30 deg off the vertical, less what of the circle is in them: from its sides,
// and tangent to it.
TEST(LiftedPipe, CarriesWhatTheBlocksOverItWeigh) {
    const scene::Scene scene = pipe();
    const packings::PreparedGround ground = packings::prepare_ground(scene);
    const auto simulation = simulation_of(scene, ground);
    while (simulation->travel() < 0.009) simulation->step();
    const double gamma = ground.density * scene.ground.gravity, H = 2.5, r = 0.5;
    const double tan_phi = std::tan(std::numbers::pi / 6), pi = std::numbers::pi;
    const double sides = 2 * r * H + H * H * tan_phi - pi * r * r / 2;
    const double up = r * 0.5, across = r * std::sqrt(0.75), h = H - up;
    const double tangent = 2 * across * h + h * h * tan_phi - r * r * (pi / 3 - std::sqrt(0.75) / 2);
    const double load = whole_plate_factor(scene) * simulation->load();
    EXPECT_GT(load, gamma * tangent);
    EXPECT_LT(load, gamma * sides * 1.02);
}

// Laid out as a staircase, the ground about it lies still.
TEST(LiftedPipe, RestsInTheGround) {
    const scene::Scene scene = pipe();
    const auto simulation = simulation_of(scene, packings::prepare_ground(scene));
    const mpm::Points start = simulation->state().points;
    for (int k = 0; k < 200; ++k) simulation->step(Vec2(0, 0));
    const mpm::Points& now = simulation->state().points;
    double most = 0;
    for (std::size_t p = 0; p < now.size(); ++p)
        most = std::max(most, std::hypot(now.x[p] - start.x[p], now.y[p] - start.y[p]));
    EXPECT_LT(most, 2e-3 * scene.domain.cell);
}

}  // namespace
}  // namespace sandgraph::simulation
