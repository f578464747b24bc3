#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"
#include "tests/support/sand_scene.hpp"

namespace sandgraph::simulation {
namespace {

// A shallow plate, H/B = 1: the sand above it rises as a block.
scene::Scene shallow(std::vector<std::string> set, int dilation = 30) {
    set.push_back(fmt::format("continuum.dilation_angle={} deg", dilation));
    return scene::parse_scene(support::sand_scene({.width = 2,
                                                   .depth = 2.5,
                                                   .thickness = 0.25,
                                                   .embedment_ratio = 1,
                                                   .pull_to = 0.02,
                                                   .young = 20}),
                              "s.toml", set);
}

// Rise of the rows of points on the symmetry plane, from the surface down, as shares of the pull.
std::vector<double> rise(const scene::Scene& scene, double pull) {
    const packings::PreparedGround ground = packings::prepare_ground(scene);
    const auto simulation = simulation_of(scene, ground);
    const mpm::Points before = simulation->state().points;
    while (simulation->travel() < pull) simulation->step();
    const mpm::Points& after = simulation->state().points;
    std::vector<std::pair<double, double>> rows;
    const double first = *std::ranges::min_element(before.x);
    for (std::size_t p = 0; p < before.size(); ++p)
        if (before.x[p] < first + 1e-9)
            rows.emplace_back(-before.y[p], (after.y[p] - before.y[p]) / simulation->travel());
    std::ranges::sort(rows);
    std::vector<double> out;
    for (const auto& [depth, share] : rows) out.push_back(share);
    return out;
}

class RisingSurface : public testing::TestWithParam<std::tuple<double, int>> {};

// Without care for light nodes the row at the surface lags by g dt: at 0.002 m/s it rises by 0.38 of the
// pull.
TEST_P(RisingSurface, GoesWithTheBlockAtEveryRate) {
    const auto [rate, points] = GetParam();
    const auto rows = rise(shallow({fmt::format("anchor.pull_rate={} m/s", rate),
                                    fmt::format("domain.points_per_cell={}", points)}),
                           0.02);
    for (int row = 0; row < 4; ++row) {
        EXPECT_GT(rows[static_cast<std::size_t>(row)], 0.97) << row;
        EXPECT_LT(rows[static_cast<std::size_t>(row)], 1.02) << row;
    }
}

// Without dilation the mechanism is not unique, and the crown spreads a little.
TEST(RisingSurface, RisesWithoutDilationToo) {
    for (const char* points : {"1", "4"}) {
        const auto rows = rise(shallow({std::string("domain.points_per_cell=") + points}, 0), 0.02);
        EXPECT_GT(rows[0], 0.96) << points;
        EXPECT_LT(rows[0], 1.02) << points;
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, RisingSurface,
                         testing::Combine(testing::Values(0.05, 0.01, 0.002), testing::Values(1)));
INSTANTIATE_TEST_SUITE_P(FourPoints, RisingSurface, testing::Values(std::tuple(0.05, 4)));

// Ground without friction and cohesion is a liquid: around a plate that does not move it rests.
TEST(FirstMotion, ALiquidDoesNotSlosh) {
    const scene::Scene scene = shallow({"continuum.friction_angle=0 deg", "domain.cell=0.25 m"}, 0);
    const auto simulation = simulation_of(scene, packings::prepare_ground(scene));
    const mpm::Points before = simulation->state().points;
    for (int step = 0; step < 3000; ++step) simulation->step(Vec2(0, 0));
    const mpm::Points& after = simulation->state().points;
    for (std::size_t p = 0; p < before.size(); ++p) {
        EXPECT_NEAR(after.x[p], before.x[p], 1e-6) << p;
        EXPECT_NEAR(after.y[p], before.y[p], 1e-6) << p;
    }
}

// The ground's answer to a pull of a hundredth of a millimetre is elastic: nothing moves further than the
// plate.
TEST(FirstMotion, MovesNothingFurtherThanThePlate) {
    const auto rows = rise(shallow({}), 1e-5);
    for (const double share : rows) {
        EXPECT_GT(share, -0.02);
        EXPECT_LT(share, 1.02);
    }
    EXPECT_GT(rows.front(), 0.4);
}

}  // namespace
}  // namespace sandgraph::simulation
