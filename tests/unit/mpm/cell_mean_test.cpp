#include "mpm/cell_mean.hpp"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "mpm/layout.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

struct Ground {
    Points points;
    Grid grid{GridShape{0, 0, 0.1, 20, 20}};
    Order order;
    explicit Ground(Points p) : points(std::move(p)) { refresh(order, points, grid); }
};

Points random_points() {
    Points points = support::random_ground(8, 10, 4, 5);
    for (std::size_t p = 0; p < points.size(); ++p) points.F_inc[p] = Mat2::Identity();
    return points;
}

void set_increment(Points& points, std::size_t p, const Mat2& H) {
    points.F_inc[p] = Mat2::Identity() + H;
    points.F[p] = points.F_inc[p] * points.F[p];
}

TEST(CellMean, LeavesAUniformGradientAlone) {
    Ground g(random_points());
    CellMean mean(0.1);
    mean.weigh(g.points, g.order, g.grid, {});
    Mat2 H;
    H << 1e-3, 2e-3, -3e-3, 4e-3;
    for (std::size_t p = 0; p < g.points.size(); ++p) set_increment(g.points, p, H);
    const std::vector<Mat2> before = g.points.F;
    mean.strain(g.order, g.points);
    for (std::size_t p = 0; p < g.points.size(); ++p) {
        EXPECT_LT((g.points.F_inc[p] - Mat2::Identity() - H).norm(), 1e-15);
        EXPECT_LT((g.points.F[p] - before[p]).norm(), 1e-14);
        EXPECT_NEAR(g.points.volume[p], g.points.volume0[p] * before[p].determinant(), 1e-12);
    }
}

TEST(CellMean, LeavesOfAnHourglassTheShareToBeKept) {
    Points points = lay_out({{0.1, 0.1, 0.7, 0.7}, 0.1, 4, 2000, {}});
    for (std::size_t p = 0; p < points.size(); ++p) {
        const bool right = std::fmod(points.x[p], 0.1) > 0.05;
        Mat2 H = Mat2::Zero();
        H(0, 0) = right ? 1e-3 : -1e-3;
        set_increment(points, p, H);
    }
    Ground g(points);
    CellMean mean(0.1);
    mean.weigh(g.points, g.order, g.grid, {});
    mean.strain(g.order, g.points);
    for (std::size_t p = 0; p < g.points.size(); ++p)
        EXPECT_NEAR(std::fabs(g.points.F_inc[p](0, 0) - 1), 1e-4, 1e-15);
}

// sum V sigma : (A L) = sum V (A sigma) : L, so that the internal force does the work that the law sees.
TEST(CellMean, KeepsThePowerOfTheStress) {
    Ground g(random_points());
    Random random(3);
    std::vector<Mat2> H(g.points.size());
    for (std::size_t p = 0; p < H.size(); ++p) {
        H[p] << random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1);
        H[p] *= 1e-4;
        set_increment(g.points, p, H[p]);
        g.points.stress[p] = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    }
    const std::vector<double> volume = g.points.volume;
    const auto power = [&](const std::vector<Stress>& s, std::size_t p, const Mat2& h) {
        return volume[p] * (s[p].xx * h(0, 0) + s[p].yy * h(1, 1) + s[p].xy * (h(0, 1) + h(1, 0)));
    };
    CellMean mean(0.3);
    mean.weigh(g.points, g.order, g.grid, {});
    const std::vector<Stress> taken = mean.stress(g.points.stress, g.order);
    double by_force = 0, by_law = 0;
    for (std::size_t p = 0; p < H.size(); ++p) by_force += power(taken, p, H[p]);
    mean.strain(g.order, g.points);
    for (std::size_t p = 0; p < H.size(); ++p)
        by_law += power(g.points.stress, p, g.points.F_inc[p] - Mat2::Identity());
    EXPECT_NEAR(by_force, by_law, 1e-13);
    EXPECT_NE(by_law, 0);
}

}  // namespace
}  // namespace sandgraph::mpm
