#include "mpm/band_stress.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

constexpr double kCell = 0.1, kLength = 0.3, kModulus = 5e7, kPressure = 2e4;

Mat2 increment(double half, double xy, double spin = 0) {
    return Mat2::Identity() + (Mat2() << half, xy - spin, xy + spin, -half).finished();
}

// Ground under pressure that is strained without being moved.
struct Ground {
    Points points = support::random_ground(10, 10, 1, 5);
    Grid grid{GridShape{0, 0, kCell, 20, 20}};
    Order order;
    BandStress bands;

    explicit Ground(double length = kLength) : bands(length, kModulus, points, kCell) {
        refresh(order, points, grid);
        std::ranges::fill(points.stress, Stress{-kPressure, -kPressure, 0});
    }
    void strain(const std::vector<Mat2>& increments) {
        points.F_inc = increments;
        total_ = bands.stress(points, order, grid);
    }
    // Radius of the added stress, by point.
    std::vector<double> added() const {
        std::vector<double> out;
        for (std::size_t p = 0; p < points.size(); ++p)
            out.push_back(deviator({total_[p].xx + kPressure, total_[p].yy + kPressure, total_[p].xy}));
        return out;
    }
    double largest() const { return std::ranges::max(added()); }

  private:
    std::span<const Stress> total_;
};

std::vector<Mat2> uniform(const Ground& g, const Mat2& F) { return {g.points.size(), F}; }

// A band two points high shears by `half` in a step; the rest stands still.
std::vector<Mat2> band(const Ground& g, double half) {
    std::vector<Mat2> F = uniform(g, Mat2::Identity());
    for (std::size_t p = 0; p < F.size(); ++p)
        if (std::fabs(g.points.y[p] - 0.7) < kCell) F[p] = increment(0, half);
    return F;
}

TEST(BandStress, IsNoneForAUniformStrain) {
    Ground g;
    for (int k = 0; k < 20; ++k) g.strain(uniform(g, increment(1e-3, -2e-3)));
    EXPECT_LT(g.largest(), 1e-9 * kPressure);
}

TEST(BandStress, IsNoneForARotation) {
    Ground g;
    for (int k = 0; k < 20; ++k) g.strain(uniform(g, increment(0, 0, 0.01)));
    EXPECT_LT(g.largest(), 1e-9 * kPressure);
}

TEST(BandStress, IsNoneOfGroundAtRest) {
    Ground g;
    g.strain(uniform(g, Mat2::Identity()));
    EXPECT_EQ(g.largest(), 0);
}

TEST(BandStress, TurnsWithTheGround) {
    Ground g;
    g.strain(band(g, 1e-4));
    const std::vector<double> before = g.added();
    constexpr int steps = 90;
    const double angle = 0.5 * std::acos(-1.0) / steps, c = std::cos(angle), s = std::sin(angle);
    const Mat2 R = (Mat2() << c, -s, s, c).finished();
    for (int k = 0; k < steps; ++k) g.strain(uniform(g, R));
    const std::vector<double> after = g.added();
    for (std::size_t p = 0; p < after.size(); ++p) EXPECT_NEAR(after[p], before[p], 1e-9 * kPressure);
}

// In steady flow X = kappa p (D - A D)/|A D|, as large for half the rate.
TEST(BandStress, DoesNotHangOnTheRate) {
    Ground slow, fast;
    for (int k = 0; k < 4000; ++k) slow.strain(band(slow, 1e-4));
    for (int k = 0; k < 2000; ++k) fast.strain(band(fast, 2e-4));
    const std::vector<double> a = slow.added(), b = fast.added();
    EXPECT_GT(slow.largest(), 0.3 * BandStress::strength * kPressure);
    for (std::size_t p = 0; p < a.size(); ++p) EXPECT_NEAR(a[p], b[p], 1e-3 * slow.largest());
}

TEST(BandStress, IsInProportionToPressure) {
    Ground weak, strong;
    std::ranges::fill(strong.points.stress, Stress{-2 * kPressure, -2 * kPressure, 0});
    for (int k = 0; k < 4000; ++k) weak.strain(band(weak, 1e-4)), strong.strain(band(strong, 1e-4));
    std::ranges::fill(weak.points.stress, Stress{});
    EXPECT_NEAR(strong.bands.work(strong.points) / weak.bands.work(weak.points), 2, 0.02);
    weak.strain(band(weak, 1e-4));
    EXPECT_EQ(weak.bands.work(weak.points), 0) << "no pressure, no stress";
}

// Over any path from rest, with the stress that each step ends with.
TEST(BandStress, NeverYieldsWork) {
    Ground g;
    Random random(3);
    double work = 0;
    for (int k = 0; k < 200; ++k) {
        std::vector<Mat2> F;
        for (std::size_t p = 0; p < g.points.size(); ++p)
            F.push_back(increment(random.uniform(-1e-4, 1e-4), random.uniform(-1e-4, 1e-4)));
        g.strain(F);
        work += g.bands.work(g.points);
        EXPECT_GT(work, 0) << k;
    }
}

TEST(BandStress, DoesNothingWithoutALength) { EXPECT_FALSE(Ground(0).bands.active()); }

}  // namespace
}  // namespace sandgraph::mpm
