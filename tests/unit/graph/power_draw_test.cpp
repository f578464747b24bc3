#include "graph/screening/power_draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.hpp"

namespace sandgraph::graph {
namespace {

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

// A few points hold most of it, as in a shear band.
std::vector<double> powers(std::size_t n) {
    Random random(7);
    std::vector<double> out(n);
    for (double& p : out) p = std::pow(random.uniform(), 8);
    return out;
}

TEST(Chances, AddUpToTheExpectedNumberAndAreOneAtMost) {
    for (const double n : {5.0, 40.0, 150.0}) {
        const auto c = chances(powers(200), n, 0.25);
        EXPECT_NEAR(sum(c), n, 1e-9 * n);
        EXPECT_LE(*std::ranges::max_element(c), 1);
    }
}

TEST(Chances, NobodyHasNoneSaveThoseThatCannotBeDrawn) {
    std::vector<double> size(100, 0);
    size[3] = 1e6, size[5] = -1;
    const auto c = chances(size, 20, 0.25);
    EXPECT_EQ(c[3], 1);
    EXPECT_EQ(c[5], 0);
    for (std::size_t p = 0; p < c.size(); ++p) EXPECT_GE(c[p], p == 5 ? 0 : 0.05) << p;
    EXPECT_NEAR(sum(c), 20, 1e-9);
}

TEST(Chances, AreEvenWhereNothingMoves) {
    for (const double c : chances(std::vector<double>(50, 0), 10, 0.25)) EXPECT_DOUBLE_EQ(c, 0.2);
}

TEST(Chances, AreOneForAllWhereMoreAreExpectedThanThereAre) {
    for (const double c : chances(powers(30), 40, 0.25)) EXPECT_EQ(c, 1);
    EXPECT_TRUE(chances({}, 40, 0.25).empty());
}

TEST(PowerDraw, TheEstimateOfASumAndThatOfItsVarianceAreUnbiased) {
    const auto size = powers(200), c = chances(size, 20, 0.25);
    double truth = 0, mean = 0, square = 0, told = 0;
    Random noise(3);
    std::vector<double> y;
    for (const double s : size) y.push_back(s * (0.5 + noise.uniform())), truth += y.back();
    constexpr int seeds = 5000;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const auto u = permanent_numbers(size.size(), seed);
        double estimate = 0;
        for (std::size_t p = 0; p < y.size(); ++p)
            if (u[p] < c[p])
                estimate += y[p] / c[p], told += (1 - c[p]) / (c[p] * c[p]) * y[p] * y[p] / seeds;
        mean += estimate / seeds, square += (estimate - truth) * (estimate - truth) / seeds;
    }
    EXPECT_NEAR(mean, truth, 4 * std::sqrt(square / seeds));
    EXPECT_NEAR(told, square, 0.1 * square);
}

TEST(PowerDraw, ANewDrawKeepsWhoseChanceStaysAboveTheirNumber) {
    auto size = powers(500);
    const auto u = permanent_numbers(500, 1), before = chances(size, 40, 0.25);
    for (double& s : size) s *= 1.02;
    size[0] += 0.05;
    const auto after = chances(size, 40, 0.25);
    int kept = 0, drawn = 0;
    for (std::size_t p = 0; p < u.size(); ++p)
        drawn += u[p] < after[p], kept += u[p] < std::min(before[p], after[p]);
    EXPECT_GE(kept, drawn - 2);
    EXPECT_GT(drawn, 20);
}

}  // namespace
}  // namespace sandgraph::graph
