#include "mpm/boundary.hpp"

#include <gtest/gtest.h>

#include "mpm/grid_update.hpp"
#include "mpm/transfer.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

Grid loaded_grid(const Points& points) {
    Grid grid(support::grid_around(8, 10));
    Order order;
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    return grid;
}

TEST(Fixed, SideNodesRestAndTheirAccelerationStopsThePoints) {
    Points points = support::random_ground(8, 10, 4, 2);
    for (double& y : points.y) y -= 0.1;
    Grid grid = loaded_grid(points);
    const GridStep update{1e-4, {0, -9.81}, 0, 1, {Side::free, Side::free, Side::fixed, Side::free}};
    update_grid(update, grid);
    int with_mass = 0;
    for (int i = -1; i <= grid.shape.nx + 1; ++i) {
        const std::size_t n = grid.shape.index(i, 0);
        const Node& node = grid.fields[0].nodes[n];
        const Motion& m = grid.fields[0].motion[n];
        EXPECT_EQ(m.vx, 0);
        EXPECT_EQ(m.vy, 0);
        if (node.mass <= 1e-6) continue;
        EXPECT_NEAR(node.py / node.mass + update.dt * m.ay, 0, 1e-9);
        ++with_mass;
    }
    EXPECT_GE(with_mass, 8);
}

TEST(GridUpdate, MassScalingSlowsTheResponseToStressButNotToTheBalance) {
    const Points points = support::random_ground(8, 10, 4, 2);
    Grid once = loaded_grid(points), scaled = once;
    update_grid({1e-4, {0, -9.81}, 0, 1, {}}, once);
    update_grid({1e-4, {0, -9.81}, 0, 4, {}}, scaled);
    for (std::size_t n = 0; n < once.shape.size(); ++n) {
        const Motion &a = once.fields[0].motion[n], &b = scaled.fields[0].motion[n];
        EXPECT_NEAR(b.ay, a.ay / 4, 1e-12 * std::abs(a.ay));  // whole unbalanced force, weight included
    }
}

TEST(GridUpdate, LocalDampingTakesItsShareOfTheUnbalancedForceAgainstTheMotion) {
    Points points = support::random_ground(8, 10, 4, 2);
    Grid free = loaded_grid(points), damped = free;
    update_grid({1e-4, {0, -9.81}, 0, 1, {}}, free);
    update_grid({1e-4, {0, -9.81}, 0.3, 1, {}}, damped);
    int speeding = 0, slowing = 0;
    for (std::size_t n = 0; n < free.shape.size(); ++n) {
        const Node& node = free.fields[0].nodes[n];
        if (node.mass < 1e-6) continue;
        const double a = free.fields[0].motion[n].ax, v = free.fields[0].motion[n].vx;
        const double expected = a * (1 - (v * a > 0 ? 0.3 : -0.3));
        EXPECT_NEAR(damped.fields[0].motion[n].ax, expected, 1e-12 * std::abs(a));
        ++(v * a > 0 ? speeding : slowing);
    }
    EXPECT_GT(speeding, 10);
    EXPECT_GT(slowing, 10);
}

}  // namespace
}  // namespace sandgraph::mpm
