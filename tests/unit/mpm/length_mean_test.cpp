#include "mpm/length_mean.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "mpm/two_field.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

constexpr double kCell = 0.1;

struct Ground {
    Points points;
    Grid grid{GridShape{0, 0, kCell, 20, 20}};
    Order order;
    explicit Ground(Points p, std::span<const Enrichment> bodies = {}) : points(std::move(p)) {
        set_bodies(grid, bodies, points.half);
        refresh(order, points, grid);
    }
    std::vector<Deviator> mean(const std::vector<Deviator>& field, double deviation) const {
        LengthMean over(deviation * deviation, points.half, kCell);
        std::vector<Deviator> out;
        over.weigh(points, order, grid);
        over.mean(field, order, out);
        return out;
    }
};

// Loosened at random, with gaps and volumes of their own.
Points random_points() {
    Points points = support::random_ground(12, 14, 4, 5);
    Random random(7);
    for (double& V : points.volume) V *= random.uniform(0.5, 1.5);
    return points;
}
Points block(int per_cell = 1) { return lay_out({{0.2, 0.2, 1.8, 1.8}, kCell, per_cell, 2000, {}}); }

std::vector<Deviator> random_field(std::size_t size, std::uint64_t seed) {
    Random random(seed);
    std::vector<Deviator> field(size);
    for (Deviator& f : field) f = {random.uniform(-1, 1), random.uniform(-1, 1)};
    return field;
}

double product(const Points& points, const std::vector<Deviator>& a, const std::vector<Deviator>& b) {
    double sum = 0;
    for (std::size_t p = 0; p < a.size(); ++p) sum += points.volume[p] * (a[p] * b[p]).sum();
    return sum;
}

TEST(LengthMean, LeavesAUniformFieldAlone) {
    const Ground g(random_points());
    for (const Deviator& f : g.mean(std::vector<Deviator>(g.points.size(), {2.0, -3.0}), 0.2)) {
        EXPECT_NEAR(f[0], 2, 1e-12);
        EXPECT_NEAR(f[1], -3, 1e-12);
    }
}

TEST(LengthMean, IsItsOwnTransposeUnderTheVolumes) {
    const Ground g(random_points());
    const auto a = random_field(g.points.size(), 1), b = random_field(g.points.size(), 2);
    const auto Aa = g.mean(a, 0.2), Ab = g.mean(b, 0.2);
    EXPECT_NEAR(product(g.points, Aa, b), product(g.points, a, Ab), 1e-13);
    EXPECT_GT(std::fabs(product(g.points, Aa, b) - product(g.points, a, b)), 1e-3);
}

// Second moment of what one row of points spreads up and down.
TEST(LengthMean, SpreadsByTheVarianceAskedFor) {
    for (const int per_cell : {1, 4})
        for (const double deviation : {0.08, 0.1, 0.15}) {
            const Ground g(block(per_cell));
            std::vector<Deviator> line(g.points.size(), Deviator::Zero());
            const double at = g.points.y[g.points.size() / 2];
            for (std::size_t p = 0; p < line.size(); ++p)
                if (std::fabs(g.points.y[p] - at) < 1e-9) line[p][0] = 1;
            const auto spread = g.mean(line, deviation);
            double sum = 0, square = 0;
            for (std::size_t p = 0; p < line.size(); ++p)
                sum += spread[p][0], square += spread[p][0] * std::pow(g.points.y[p] - at, 2);
            EXPECT_NEAR(std::sqrt(square / sum) / deviation, 1, 0.03) << per_cell << ' ' << deviation;
        }
}

TEST(LengthMean, LetsNothingThroughAThinBody) {
    Enrichment cut;
    cut.active = true, cut.level = 1, cut.low = -1, cut.high = 3, cut.half_thickness = 0.01;
    const Ground g(block(), std::span(&cut, 1));
    std::vector<Deviator> above(g.points.size(), Deviator::Zero());
    for (std::size_t p = 0; p < above.size(); ++p)
        if (g.points.y[p] > cut.level) above[p] = {1, 2};
    const auto mean = g.mean(above, 0.2);
    for (std::size_t p = 0; p < above.size(); ++p) {
        EXPECT_NEAR(mean[p][0], above[p][0], 1e-12);
        EXPECT_NEAR(mean[p][1], above[p][1], 1e-12);
    }
}

TEST(LengthMean, TakesAFewPasses) {
    EXPECT_EQ(LengthMean(0, 0.05, kCell).passes(), 0);
    EXPECT_LE(LengthMean(std::pow(0.4 / 2.355, 2), 0.05, kCell).passes(), 6);
}

}  // namespace
}  // namespace sandgraph::mpm
