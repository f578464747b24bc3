#include <gtest/gtest.h>

#include <cmath>

#include "mpm/audit.hpp"
#include "mpm/boundary.hpp"
#include "mpm/grid_update.hpp"
#include "mpm/plate.hpp"
#include "mpm/transfer.hpp"
#include "mpm/two_field.hpp"
#include "tests/support/random_ground.hpp"

// A half with a mirror for a side against the whole, forces on volumes, gravity, and what is audited.
namespace sandgraph::mpm {
namespace {

constexpr double cell = 0.1;

Grid moved(const GridShape& shape, const Points& points, const Vec2& gravity, const Boundaries& sides) {
    Grid grid(shape);
    Order order;
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    update_grid({1e-4, gravity, 0.05, 1, sides}, grid);
    return grid;
}

void append_mirrored(Points& points, bool about_x) {
    const std::size_t n = points.size();
    resize(points, 2 * n);
    for (std::size_t p = 0; p < n; ++p) {
        const double sx = about_x ? -1 : 1, sy = -sx;
        points.x[n + p] = sx * points.x[p], points.y[n + p] = sy * points.y[p];
        points.vx[n + p] = sx * points.vx[p], points.vy[n + p] = sy * points.vy[p];
        points.mass[n + p] = points.mass[p], points.volume[n + p] = points.volume[p];
        const Stress& s = points.stress[p];
        points.stress[n + p] = {s.xx, s.yy, -s.xy};
    }
}

// The lowest points lie a tenth of a cell beside the plane, so that their stencils reach across it.
Points beside_the_plane() {
    Points points = support::random_ground(8, 10, 4, 6);
    for (double& x : points.x) x -= 0.15;
    for (double& y : points.y) y -= 0.15;
    for (std::size_t p = 0; p < points.size(); ++p)
        points.x[p] = std::abs(points.x[p]) + 1e-3, points.y[p] = std::abs(points.y[p]) + 1e-3;
    return points;
}

TEST(MirrorSide, AHalfMovesAsTheWholeOnEveryNode) {
    for (const bool left : {true, false}) {
        const Points half_points = beside_the_plane();
        Points whole_points = half_points;
        append_mirrored(whole_points, left);
        Boundaries sides;
        (left ? sides.left : sides.bottom) = Side::mirror;
        const GridShape half_shape{left ? 0 : -1.4, left ? -1.4 : 0, cell, left ? 14 : 28, left ? 28 : 14};
        const GridShape whole_shape{-1.4, -1.4, cell, 28, 28};
        const Vec2 along = left ? Vec2(0, -9.81) : Vec2(3, 0);
        const Grid half = moved(half_shape, half_points, along, sides);
        const Grid whole = moved(whole_shape, whole_points, along, {});
        for (int j = left ? -14 : -1; j <= 12; ++j)
            for (int i = left ? -1 : -14; i <= 12; ++i) {
                const Motion& a = whole.fields[0].motion[whole_shape.index(i + 14, j + 14)];
                const Motion& b =
                    half.fields[0].motion[half_shape.index(left ? i : i + 14, left ? j + 14 : j)];
                const double scale = 1e-9 * (1 + std::hypot(a.ax, a.ay));
                EXPECT_NEAR(a.vx, b.vx, 1e-9) << left << " " << i << " " << j;
                EXPECT_NEAR(a.vy, b.vy, 1e-9) << left << " " << i << " " << j;
                EXPECT_NEAR(a.ax, b.ax, scale) << left << " " << i << " " << j;
                EXPECT_NEAR(a.ay, b.ay, scale) << left << " " << i << " " << j;
            }
    }
}

// On the plane itself nothing may cross, whatever the points did to it.
TEST(MirrorSide, NodesOfThePlaneKeepTheMomentumAndForceAlongItOnly) {
    const Points points = beside_the_plane();
    Grid grid(GridShape{0, -0.2, cell, 14, 16});
    Order order;
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    double mass = 0, folded = 0;
    for (const Node& n : grid.fields[0].nodes) mass += n.mass;
    fold(grid.fields[0], grid.shape, {Side::mirror, Side::free, Side::free, Side::free});
    for (const Node& n : grid.fields[0].nodes) folded += n.mass;
    EXPECT_NEAR(folded, mass, 1e-12 * mass);
    for (int j = -1; j <= 15; ++j) {
        EXPECT_EQ(grid.fields[0].nodes[grid.shape.index(0, j)].px, 0);
        EXPECT_EQ(grid.fields[0].nodes[grid.shape.index(0, j)].fx, 0);
        EXPECT_EQ(grid.fields[0].nodes[grid.shape.index(-1, j)].mass, 0);
    }
}

TEST(FixedSide, StopsBothComponentsOfWhatFallsOnIt) {
    const Points points = beside_the_plane();
    Grid grid(GridShape{-0.2, 0, cell, 16, 14});
    Order order;
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    const std::vector<Node> before = grid.fields[0].nodes;
    update_grid({1e-4, {0, -9.81}, 0, 1, {Side::free, Side::free, Side::fixed, Side::free}}, grid);
    int met = 0;
    for (int i = 1; i <= 9; ++i)
        for (const int j : {-1, 0}) {
            const std::size_t n = grid.shape.index(i, j);
            if (before[n].mass < 1e-6) continue;
            const Motion& m = grid.fields[0].motion[n];
            EXPECT_NEAR(before[n].px / before[n].mass + 1e-4 * m.ax, 0, 1e-9);
            EXPECT_NEAR(before[n].py / before[n].mass + 1e-4 * m.ay, 0, 1e-9);
            EXPECT_EQ(m.vx, 0);
            EXPECT_EQ(m.vy, 0);
            ++met;
        }
    EXPECT_GE(met, 9);
}

TEST(GridUpdate, FreeNodesFallWithGravity) {
    Points points = support::random_ground(4, 4, 1, 3);
    std::fill(points.stress.begin(), points.stress.end(), Stress{});
    Grid grid(support::grid_around(4, 4));
    Order order;
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    update_grid({1e-3, {1, -9.81}, 0, 1, {}}, grid);
    int heavy = 0;
    for (std::size_t n = 0; n < grid.shape.size(); ++n) {
        if (grid.fields[0].nodes[n].mass < 1e-6) continue;
        EXPECT_NEAR(grid.fields[0].motion[n].ax, 1, 1e-9);
        EXPECT_NEAR(grid.fields[0].motion[n].ay, -9.81, 1e-9);
        ++heavy;
    }
    EXPECT_GT(heavy, 15);
}

// Ground that has grown to twice its volume presses with twice the force, beside a plate as well.
TEST(InternalForce, IsOfThePresentVolume) {
    for (const bool plate : {false, true}) {
        Points points = support::random_ground(10, 10, 1, 5);
        const auto forces = [&] {
            Grid grid(support::grid_around(10, 10));
            Order order;
            if (plate) set_bodies(grid, std::array{enrichment_of({0.7, 0.7, 0.5, 0.05})}, points.half);
            refresh(order, points, grid);
            EXPECT_EQ(order.near.empty(), !plate);
            points_to_grid(points, order, grid);
            std::vector<double> out;
            for (const Field& field : grid.fields)
                for (const Node& n : field.nodes) out.push_back(n.fx), out.push_back(n.fy);
            return out;
        };
        const std::vector<double> once = forces();
        for (double& v : points.volume) v *= 2;
        const std::vector<double> twice = forces();
        for (std::size_t k = 0; k < once.size(); ++k)
            EXPECT_NEAR(twice[k], 2 * once[k], 1e-9 * (1 + std::abs(once[k])));
    }
}

TEST(Plate, AdvancesByItsVelocity) {
    RigidPlate plate{1, 2, 0.5, 0.05};
    plate.velocity = {0.3, -0.7};
    advance(plate, 0.1);
    EXPECT_NEAR(plate.x, 1.03, 1e-15);
    EXPECT_NEAR(plate.y, 1.93, 1e-15);
}

TEST(Audit, EnergiesAndWorkOfTwoPointsByHand) {
    Points points;
    resize(points, 2);
    points.mass = {2, 3}, points.vx = {1, 0}, points.vy = {0, -2};
    points.x = {1, 2}, points.y = {3, 5}, points.volume = {0.5, 4};
    points.F_inc[0] << 1 + 1e-3, 2e-3, 4e-3, 1 - 3e-3;
    points.stress[0] = {10, 20, 5};
    EXPECT_DOUBLE_EQ(kinetic_energy(points, 1), 0.5 * (2 * 1 + 3 * 4));
    EXPECT_DOUBLE_EQ(kinetic_energy(points, 7), 3.5 * (2 * 1 + 3 * 4));
    EXPECT_DOUBLE_EQ(gravity_potential(points, {0.5, -10}), -2 * 0.5 + 2 * 10 * 3 - 3 * 0.5 * 2 + 3 * 10 * 5);
    EXPECT_NEAR(stress_work(points), 0.5 * (10 * 1e-3 + 20 * -3e-3 + 5 * 6e-3), 1e-15);
    EXPECT_DOUBLE_EQ(angular_momentum(points), 2 * (1 * 0 - 3 * 1) + 3 * (2 * -2 - 5 * 0));
    EXPECT_EQ(momentum(points), Vec2(2, -6));
}

// The ground holds a plate that rises back: the plate does work.
TEST(Audit, APlateThatIsHeldBackDoesWork) {
    RigidPlate plate;
    plate.velocity = {0.5, 2};
    Reaction reaction;
    reaction.on[1] = {0, -100}, reaction.on[4] = {-8, 0};
    EXPECT_DOUBLE_EQ(plate_work(plate, reaction, 0.01), 0.01 * (8 * 0.5 + 100 * 2));
}

}  // namespace
}  // namespace sandgraph::mpm
