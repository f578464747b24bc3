#include "mpm/transfer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mpm/audit.hpp"
#include "mpm/two_field.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

struct Sums {
    double mass = 0, px = 0, py = 0, fx = 0, fy = 0, spin = 0, moment = 0, force_scale = 0;
};

Sums sum(const Grid& grid) {
    Sums s;
    for (int j = -1; j <= grid.shape.ny + 1; ++j)
        for (int i = -1; i <= grid.shape.nx + 1; ++i) {
            const Node& n = grid.fields[0].nodes[grid.shape.index(i, j)];
            const double x = grid.shape.x(i), y = grid.shape.y(j);
            s.mass += n.mass, s.px += n.px, s.py += n.py, s.fx += n.fx, s.fy += n.fy;
            s.spin += x * n.py - y * n.px, s.moment += x * n.fy - y * n.fx;
            s.force_scale += std::fabs(n.fx) + std::fabs(n.fy);
        }
    return s;
}

class PointsToGrid : public testing::TestWithParam<int> {
  protected:
    Points points = support::random_ground(20, 30, GetParam(), 7);
    Grid grid{support::grid_around(20, 30)};
    Order order;
    void SetUp() override {
        refresh(order, points, grid);
        points_to_grid(points, order, grid);
    }
};

TEST_P(PointsToGrid, ConservesMassAndLinearMomentum) {
    const Sums s = sum(grid);
    const Vec2 p = momentum(points);
    EXPECT_NEAR(s.mass, total_mass(points), 1e-12 * s.mass);
    EXPECT_NEAR(s.px, p.x(), 1e-12 * s.mass);
    EXPECT_NEAR(s.py, p.y(), 1e-12 * s.mass);
}

TEST_P(PointsToGrid, ConservesAngularMomentum) {  // sum_i S_ip x_i = x_p: linear fields are reproduced
    EXPECT_NEAR(sum(grid).spin, angular_momentum(points), 1e-12 * total_mass(points));
}

TEST_P(PointsToGrid, InternalForcesHaveNeitherResultantNorMoment) {
    const Sums s = sum(grid);
    EXPECT_NEAR(s.fx, 0, 1e-13 * s.force_scale);
    EXPECT_NEAR(s.fy, 0, 1e-13 * s.force_scale);
    EXPECT_NEAR(s.moment, 0, 1e-12 * s.force_scale);
}

TEST_P(PointsToGrid, VectorKernelEqualsThePlainSum) {
    Grid plain(grid.shape);
    std::vector<std::int32_t> all(points.size());
    for (std::size_t p = 0; p < all.size(); ++p) all[p] = static_cast<std::int32_t>(p);
    scatter_enriched(all, points, points.stress, plain);
    for (std::size_t n = 0; n < grid.shape.size(); ++n) {
        const Node &a = grid.fields[0].nodes[n], &b = plain.fields[0].nodes[n];
        EXPECT_NEAR(a.mass, b.mass, 1e-12);
        EXPECT_NEAR(a.px, b.px, 1e-12);
        EXPECT_NEAR(a.py, b.py, 1e-12);
        EXPECT_NEAR(a.fx, b.fx, 1e-8);
        EXPECT_NEAR(a.fy, b.fy, 1e-8);
    }
}

INSTANTIATE_TEST_SUITE_P(PointsPerCell, PointsToGrid, testing::Values(1, 4, 9));

TEST(PointsToGrid, RefusesAnOrderThatIsStale) {
    Points points = support::random_ground(4, 4, 1, 7);
    Grid grid(support::grid_around(4, 4));
    Order order;
    EXPECT_THROW(points_to_grid(points, order, grid), std::logic_error);
}

}  // namespace
}  // namespace sandgraph::mpm
