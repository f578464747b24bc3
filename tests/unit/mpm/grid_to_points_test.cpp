#include "mpm/transfer.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <limits>

#include "mpm/two_field.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

// v = v0 + L x on every node, acceleration a.
void set_motion(Grid& grid, const Vec2& v0, const Mat2& L, const Vec2& a) {
    for (int j = -1; j <= grid.shape.ny + 1; ++j)
        for (int i = -1; i <= grid.shape.nx + 1; ++i) {
            const Vec2 v = v0 + L * Vec2(grid.shape.x(i), grid.shape.y(j));
            grid.fields[0].motion[grid.shape.index(i, j)] = {v.x(), v.y(), a.x(), a.y()};
        }
}

struct GridToPoints : testing::Test {
    Points points = support::random_ground(12, 20, 4, 5);
    Grid grid{support::grid_around(12, 20)};
    Order order;
    const Vec2 v0{0.3, -0.2}, a{2, -5};
    const Mat2 L = (Mat2() << 0.5, -0.7, 0.2, 0.9).finished();
    void SetUp() override {
        refresh(order, points, grid);
        set_motion(grid, v0, L, a);
    }
};

TEST_F(GridToPoints, ReadsALinearVelocityFieldExactly) {
    const double dt = 1e-3;
    const Points before = points;
    ASSERT_TRUE(grid_to_points(grid, {dt, 0}, order, points).good());
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Vec2 v = v0 + L * Vec2(before.x[p], before.y[p]);
        EXPECT_NEAR(points.x[p], before.x[p] + dt * v.x(), 1e-14);
        EXPECT_NEAR(points.y[p], before.y[p] + dt * v.y(), 1e-14);
        EXPECT_LT((points.F_inc[p] - (Mat2::Identity() + dt * L)).norm(), 1e-13);
    }
}

TEST_F(GridToPoints, DeformationGradientIsTheProductOfIncrements) {
    const double dt = 1e-2;
    grid_to_points(grid, {dt, 0}, order, points);
    refresh(order, points, grid);
    grid_to_points(grid, {dt, 0}, order, points);
    const Mat2 step = Mat2::Identity() + dt * L, F = step * step;
    for (std::size_t p = 0; p < points.size(); ++p) {
        EXPECT_LT((points.F[p] - F).norm(), 1e-13);
        EXPECT_NEAR(points.volume[p], points.volume0[p] * F.determinant(), 1e-15);
    }
}

TEST_F(GridToPoints, FlipKeepsThePointsOwnVelocityAndPicTakesTheGrids) {
    const double dt = 1e-3;
    Points flip = points, pic = points;
    Order other = order;
    grid_to_points(grid, {dt, 0}, order, flip);
    grid_to_points(grid, {dt, 1}, other, pic);
    for (std::size_t p = 0; p < points.size(); ++p) {
        EXPECT_NEAR(flip.vx[p], points.vx[p] + dt * a.x(), 1e-14);
        EXPECT_NEAR(pic.vy[p], (v0 + L * Vec2(points.x[p], points.y[p])).y(), 1e-13);
    }
}

TEST_F(GridToPoints, VectorKernelEqualsThePlainSum) {
    Points plain = points;
    std::vector<std::int32_t> all(order.ids);
    gather_enriched(all, grid, {1e-3, 0.3}, plain);
    grid_to_points(grid, {1e-3, 0.3}, order, points);
    for (std::size_t p = 0; p < points.size(); ++p) {
        EXPECT_NEAR(points.x[p], plain.x[p], 1e-14);
        EXPECT_NEAR(points.vy[p], plain.vy[p], 1e-13);
        EXPECT_LT((points.F[p] - plain.F[p]).norm(), 1e-13);
    }
}

TEST_F(GridToPoints, ReportsThePointsThatLeaveAndTheNextStepRefuses) {
    points.x[17] = grid.shape.nx * grid.shape.cell - 1e-6;
    points.x[40] = points.x[17];
    set_motion(grid, {1, 0}, Mat2::Zero(), Vec2::Zero());
    const Status status = grid_to_points(grid, {1e-3, 0}, order, points);
    EXPECT_EQ(status.outside, 2);
    EXPECT_EQ(status.first, 17);
    EXPECT_THROW(refresh(order, points, grid), std::runtime_error);
}

TEST_F(GridToPoints, TreatsANanPositionAsOutside) {
    set_motion(grid, {std::numeric_limits<double>::quiet_NaN(), 0}, Mat2::Zero(), Vec2::Zero());
    EXPECT_EQ(grid_to_points(grid, {1e-3, 0}, order, points).outside, static_cast<int>(points.size()));
}

}  // namespace
}  // namespace sandgraph::mpm
