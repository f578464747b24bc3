#include "results/peak.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/random.hpp"
#include "results/smoothing.hpp"

namespace sandgraph::results {
namespace {

struct Curve {
    std::vector<double> d, load;
};

Curve curve(const std::function<double(double)>& f, double noise = 0, double to = 0.4, double step = 0.0005) {
    Random random(3);
    Curve c;
    for (double d = 0; d <= to; d += step) {
        c.d.push_back(d);
        c.load.push_back(f(d) + noise * random.uniform(-1, 1));
    }
    return c;
}

Breakout of(const Curve& c) { return breakout(c.d, c.load); }

// Rises to 3 at d = 0.02, softens to 2 (dense sand).
double softening(double d) {
    const double t = d / 0.02;
    return t < 1 ? 3 * t * (2 - t) : 2 + std::exp(-0.5 * (t - 1) * (t - 1) / 9);
}

double plateau(double d) { return 2 * (1 - std::exp(-d / 0.02)); }
double hardening(double d) { return plateau(d) + 1.5 * d; }  // steady slope at last
double root(double d) { return std::sqrt(d); }               // slope never steady

TEST(Breakout, PeakOfASofteningCurve) {
    const Breakout b = of(curve(softening));
    EXPECT_EQ(b.kind, BreakoutKind::zero_slope);
    EXPECT_NEAR(b.d_over_B, 0.02, 0.003);  // of the smoothing window's 0.005
    EXPECT_NEAR(b.load, 3, 0.02);
}

TEST(Breakout, PeakSurvivesNoise) {
    for (const double noise : {0.02, 0.05, 0.1}) {
        const Breakout b = of(curve(softening, noise));
        EXPECT_EQ(b.kind, BreakoutKind::zero_slope);
        EXPECT_NEAR(b.d_over_B, 0.02, 0.008) << noise;
        EXPECT_NEAR(b.load, 3, 0.02 + 0.6 * noise) << noise;
    }
}

TEST(Breakout, PlateauIsReachedWhereTheSlopeVanishes) {
    const Breakout b = of(curve(plateau));
    EXPECT_NE(b.kind, BreakoutKind::still_rising);
    EXPECT_NEAR(b.load, 2, 0.06);
    EXPECT_GT(b.d_over_B, 0.05);
    const Breakout noisy = of(curve(plateau, 0.03));
    EXPECT_NE(noisy.kind, BreakoutKind::still_rising);
    EXPECT_NEAR(noisy.load, 2, 0.08);
}

TEST(Breakout, SteadyMinimumSlopeOfAHardeningCurve) {
    for (const double noise : {0.0, 0.01}) {
        const Breakout b = of(curve(hardening, noise));
        EXPECT_EQ(b.kind, BreakoutKind::steady_slope) << noise;
        EXPECT_NEAR(b.d_over_B, -0.02 * std::log(0.02), 0.015) << noise;
        EXPECT_NEAR(b.load, hardening(b.d_over_B), 0.03) << noise;
    }
}

TEST(Breakout, StillRisingCurvesAreSaidToBeSo) {
    for (const auto& f : std::vector<std::function<double(double)>>{
             root, [](double d) { return 5 * d; }, [](double d) { return 1 - std::exp(-d / 0.15); }}) {
        const Breakout b = of(curve(f));
        EXPECT_EQ(b.kind, BreakoutKind::still_rising);
        EXPECT_NEAR(b.load, f(0.4), 0.01);
    }
}

// A piece of any smooth curve is straight if it is short.
TEST(Breakout, CurvesCutBeforeTheirPeakAreStillRising) {
    for (const double to : {0.006, 0.008, 0.01, 0.015})
        for (const double noise : {0.0, 0.02}) {
            const Breakout b = of(curve(softening, noise, to));
            EXPECT_EQ(b.kind, BreakoutKind::still_rising) << to << " " << noise;
        }
    // Plates at H/B = 50: steady from 0.15 to 0.2 B, they broke out at 0.26 B and a third above.
    EXPECT_EQ(of(curve(hardening, 0, 0.2)).kind, BreakoutKind::still_rising);
}

TEST(Breakout, ShortDropOnTheWayUpIsNoBreakout) {
    const auto wiggle = [](double d) {
        return softening(d / 2) - 0.08 * std::exp(-std::pow((d - 0.015) / 0.003, 2));
    };
    const Breakout b = of(curve(wiggle));
    EXPECT_NEAR(b.d_over_B, 0.04, 0.004);
    EXPECT_NEAR(b.load, 3, 0.02);
}

TEST(Breakout, FirstSofteningCountsEvenIfTheLoadRisesHigherLater) {
    const auto twice = [](double d) { return softening(d) + 40 * std::max(0.0, d - 0.2) * (d - 0.2); };
    EXPECT_NEAR(of(curve(twice)).d_over_B, 0.02, 0.003);
}

TEST(Breakout, ScalesWithTheLoadAndIgnoresItsUnit) {
    Curve c = curve(softening, 0.05);
    const Breakout one = of(c);
    for (double& load : c.load) load *= 46e3;
    const Breakout scaled = of(c);
    EXPECT_EQ(scaled.d_over_B, one.d_over_B);
    EXPECT_NEAR(scaled.load, 46e3 * one.load, 1e-6);
}

TEST(Breakout, EmptyShortAndConstantCurvesDoNotFail) {
    EXPECT_EQ(breakout({}, {}).kind, BreakoutKind::still_rising);
    const std::vector<double> three{0, 0.1, 0.2};
    EXPECT_EQ(breakout(three, three).load, 0.2);
    EXPECT_TRUE(std::isfinite(of(curve([](double) { return 0.0; })).load));
}

TEST(LateLoad, IsTheMeanOverTheLastTenth) {
    const Curve c = curve([](double d) { return d; }, 0, 1.0, 0.001);
    EXPECT_NEAR(late_load(c.d, c.load), 0.95, 1e-3);
    EXPECT_EQ(late_load({}, {}), 0);
}

TEST(Smoothing, ReproducesAQuadraticWithItsSlopeOnAnySpacing) {
    std::vector<double> x, y;
    for (int k = 0; k < 60; ++k) x.push_back(0.001 * k * k);
    for (const double t : x) y.push_back(2 - 3 * t + 0.5 * t * t);
    const Smoothed s = smooth(x, y, 0.05);
    for (std::size_t k = 0; k < x.size(); ++k) {
        EXPECT_NEAR(s.value[k], y[k], 1e-9);
        EXPECT_NEAR(s.slope[k], -3 + x[k], 1e-6);
    }
}

}  // namespace
}  // namespace sandgraph::results
