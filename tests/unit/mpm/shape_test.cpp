#include "mpm/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"

namespace sandgraph::mpm {
namespace {

constexpr double cell = 0.37;

double hat(double x, int node) { return std::max(0.0, 1 - std::fabs(x / cell - node)); }

// Mid-point rule with so many intervals that the hat's kinks do not matter at the tolerance used.
double brute_force_average(double a, double b, int node) {
    constexpr int intervals = 20000;
    double sum = 0;
    for (int k = 0; k < intervals; ++k) sum += hat(a + (b - a) * (k + 0.5) / intervals, node);
    return sum / intervals;
}

template <class F>
void for_random_intervals(F f) {
    Random random(3);
    for (int k = 0; k < 50; ++k) {
        const double a = random.uniform(-2, 5), width = cell * random.uniform(1e-3, 1);
        f(a, a + width, average(a, a + width, cell));
    }
}

TEST(UniformGimp, IsAPartitionOfUnity) {
    for_random_intervals([](double, double, const Weights& w) {
        EXPECT_NEAR(w.S[0] + w.S[1] + w.S[2], 1, 1e-15);
        EXPECT_NEAR(w.dS[0] + w.dS[1] + w.dS[2], 0, 1e-13);
        for (const double S : w.S) EXPECT_GE(S, -1e-15);
    });
}

TEST(UniformGimp, ReproducesALinearField) {
    for_random_intervals([](double a, double b, const Weights& w) {
        double value = 0, slope = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = cell * (w.base + static_cast<int>(i));
            value += w.S[i] * x, slope += w.dS[i] * x;
        }
        EXPECT_NEAR(value, 0.5 * (a + b), 1e-13);
        EXPECT_NEAR(slope, 1, 1e-10);
    });
}

TEST(UniformGimp, MatchesBruteForceIntegrationOfTheHats) {
    for_random_intervals([](double a, double b, const Weights& w) {
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            EXPECT_NEAR(w.S[k], brute_force_average(a, b, w.base + i), 1e-8);
            EXPECT_NEAR(w.dS[k], (hat(b, w.base + i) - hat(a, w.base + i)) / (b - a), 1e-9);
        }
    });
}

TEST(UniformGimp, GradientIsTheDerivativeOfTheWeight) {
    for_random_intervals([](double a, double b, const Weights& w) {
        const double h = 1e-6;
        const Weights left = average(a - h, b - h, cell), right = average(a + h, b + h, cell);
        if (left.base != right.base) return;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(w.dS[k], (right.S[k] - left.S[k]) / (2 * h), 1e-4);
    });
}

TEST(Hat, IsTheLimitOfANarrowDomain) {
    const Weights narrow = average(0.5, 0.5 + 1e-9, cell), point = at(0.5, cell);
    ASSERT_EQ(narrow.base, point.base);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(narrow.S[k], point.S[k], 1e-8);
}

}  // namespace
}  // namespace sandgraph::mpm
