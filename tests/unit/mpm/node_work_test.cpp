#include "mpm/node_work.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mpm/light_nodes.hpp"
#include "mpm/transfer.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

constexpr Boundaries kFree{Side::free, Side::free, Side::free, Side::free};

Grid one_node(double vx, double fx) {
    Grid grid({0, 0, 1, 4, 4});
    grid.point_mass = 1;
    Field& f = grid.fields[0];
    f.box = whole(grid.shape);
    f.nodes[grid.shape.index(2, 2)] = {2, 2 * vx, 0, fx, 0};
    return grid;
}

// f = 8 N/m against 0.25 |f| of damping, inertia 3 x 2 kg/m, from 5 m/s: a = 1 m/s2.
TEST(NodeWork, OfDampingIsItsForceTimesTheVelocity) {
    Grid grid = one_node(5, 8);
    const GridStep step{0.1, Vec2::Zero(), 0.25, 3, kFree};
    update_grid(step, grid);
    const NodeWork work = node_work(step, grid);
    EXPECT_NEAR(work.damping, 2 * 5.1 * 0.1, 1e-12);
    EXPECT_NEAR(work.gained, 6 * 5.05 * 0.1, 1e-12);
}

TEST(NodeWork, DampingTakesWhicheverWayTheNodeGoes) {
    for (const double v : {5.0, -5.0}) {
        Grid grid = one_node(v, 8);
        const GridStep step{0.1, Vec2::Zero(), 0.25, 1, kFree};
        update_grid(step, grid);
        EXPECT_GT(node_work(step, grid).damping, 0) << v;
    }
}

double kinetic(const Grid& grid, double scaling, double sign_dt) {
    double sum = 0;
    const Field& f = grid.fields[0];
    for (std::size_t n = 0; n < f.nodes.size(); ++n) {
        const Vec2 v = Vec2(f.motion[n].vx, f.motion[n].vy) + sign_dt * Vec2(f.motion[n].ax, f.motion[n].ay);
        sum += 0.5 * scaling * f.nodes[n].mass * v.squaredNorm();
    }
    return sum;
}

Grid loaded_grid(Points& points) {
    for (double& y : points.y) y -= 0.1;
    Grid grid(support::grid_around(8, 10));
    Order order;
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    return grid;
}

// Sides, a symmetry plane and light nodes among them.
TEST(NodeWork, IsWhatTheNodesKineticEnergyTakesUp) {
    Points points = support::random_ground(8, 10, 4, 2);
    Grid grid = loaded_grid(points);
    const GridStep step{1e-4,
                        {0, -9.81},
                        0.3,
                        2,
                        {Side::mirror, Side::mirror, Side::fixed, Side::free},
                        light_mass(points, grid.shape)};
    update_grid(step, grid);
    const double change = kinetic(grid, 2, 0) - kinetic(grid, 2, -step.dt);
    EXPECT_GT(std::fabs(change), 0);
    EXPECT_NEAR(node_work(step, grid).gained, change, 1e-9 * kinetic(grid, 2, -step.dt));
}

// What holds a node is no damping, and without damping there is none.
TEST(NodeWork, OfTheSidesIsNotDamping) {
    Points points = support::random_ground(8, 10, 4, 2);
    Grid grid = loaded_grid(points);
    const GridStep step{1e-4, {0, -9.81}, 0, 1, {Side::mirror, Side::mirror, Side::fixed, Side::free}};
    update_grid(step, grid);
    EXPECT_NEAR(node_work(step, grid).damping, 0, 1e-12 * kinetic(grid, 1, 0));
}

}  // namespace
}  // namespace sandgraph::mpm
