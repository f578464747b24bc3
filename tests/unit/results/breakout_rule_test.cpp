#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/csv.hpp"
#include "results/peak.hpp"
#include "support/paths.hpp"

// The constants of the breakout rule, from which every N_gamma comes: curves to both sides of each.
namespace sandgraph::results {
namespace {

Breakout of(const std::function<double(double)>& f, double to = 0.4, double step = 0.0005) {
    std::vector<double> d, load;
    for (int k = 0; k * step <= to + 1e-12; ++k) d.push_back(k * step), load.push_back(f(d.back()));
    return breakout(d, load);
}

// Straight between corners (d/B, load), level after the last.
struct Corners {
    std::vector<std::pair<double, double>> at;
    double operator()(double d) const {
        for (std::size_t k = 1; k < at.size(); ++k)
            if (d <= at[k].first)
                return std::lerp(at[k - 1].second, at[k].second,
                                 (d - at[k - 1].first) / (at[k].first - at[k - 1].first));
        return at.back().second;
    }
};

// As the run's own summary said.
TEST(BreakoutRule, OfARealCurveGivesItsFactorToThreeDigits) {
    CsvReader in(test::test_data("/load/quick_dense.csv"));
    std::vector<double> d, load;
    for (in.next_row(); in.next_row();)
        d.push_back(in.number(in.cells()[0])), load.push_back(in.number(in.cells()[1]));
    const Breakout b = breakout(d, load);
    EXPECT_EQ(b.kind, BreakoutKind::zero_slope);
    EXPECT_NEAR(b.load / 43840.0749, 2.404, 5e-4);
    EXPECT_NEAR(b.d_over_B, 0.00876, 1e-5);
}

// Down from 1 at 0.05 and up again to `second` at 0.065.
TEST(BreakoutRule, ALoadThatRisesAgainByMoreThanAHundredthIsNone) {
    const auto peak = [](double second) {
        return of(Corners{{{0, 0}, {0.05, 1}, {0.058, 0.9}, {0.065, second}, {0.1, 0.5}}}).d_over_B;
    };
    EXPECT_NEAR(peak(1.00), 0.05, 0.003);
    EXPECT_NEAR(peak(1.06), 0.065, 0.003);
}

// Above the first peak from `from` on.
TEST(BreakoutRule, ALoadThatRisesAgainLaterThanTwoHundredthsIsABreakout) {
    const auto peak = [](double from) {
        return of(Corners{{{0, 0}, {0.05, 1}, {0.06, 0.8}, {from, 0.9}, {from + 0.001, 1.3}, {0.3, 1}}})
            .d_over_B;
    };
    EXPECT_NEAR(peak(0.0755), 0.05, 0.003);
    EXPECT_GT(peak(0.066), 0.06);
}

TEST(BreakoutRule, NeedsAHundredthAfterThePeakToTell) {
    const Corners curve{{{0, 0}, {0.05, 1}, {0.1, 0.5}}};
    EXPECT_EQ(of(curve, 0.0575).kind, BreakoutKind::still_rising);
    EXPECT_EQ(of(curve, 0.0625).kind, BreakoutKind::zero_slope);
}

TEST(BreakoutRule, ADipBelowAQuarterOfTheLargestLoadIsNoBreakout) {
    const auto peak = [](double first) {
        return of(Corners{{{0, 0}, {0.03, first}, {0.06, 0.8 * first}, {0.15, 1}, {0.3, 0.8}}}).d_over_B;
    };
    EXPECT_NEAR(peak(0.29), 0.03, 0.003);
    EXPECT_NEAR(peak(0.23), 0.15, 0.003);
}

double hardening(double d) { return 2 * (1 - std::exp(-d / 0.02)) + 1.5 * d; }

TEST(BreakoutRule, TheSteadySlopeIsReachedAtTwoHundredthsOfTheFirst) {
    const Breakout b = of(hardening);
    ASSERT_EQ(b.kind, BreakoutKind::steady_slope);
    // The smoothed slope is steepest at the start, 0.9 of the curve's own.
    EXPECT_NEAR(b.d_over_B, -0.02 * std::log(0.02), 0.003);
    EXPECT_NEAR(b.load, hardening(b.d_over_B), 0.005);
}

TEST(BreakoutRule, ASteadyStretchIsAQuarterOfTheCurveAndNineHundredthsLong) {
    EXPECT_EQ(of(hardening, 0.350).kind, BreakoutKind::still_rising);
    EXPECT_EQ(of(hardening, 0.370).kind, BreakoutKind::steady_slope);
}

// Slope 1.5 + 2 b d: over the last quarter, 0.3 to 0.4, its halves differ by 0.1 b, of a mean of 1.5 + 0.7 b.
TEST(BreakoutRule, ASlopeThatChangesByMoreThanATwentiethIsNotSteady) {
    const auto bent = [](double b) { return of([=](double d) { return hardening(d) + b * d * d; }).kind; };
    EXPECT_EQ(bent(1.05), BreakoutKind::steady_slope);
    EXPECT_EQ(bent(1.25), BreakoutKind::still_rising);
}

TEST(BreakoutRule, ASlopeAboveHalfTheSteepestIsNoMinimum) {
    const auto steep = [](double last) {
        return of(Corners{{{0, 0}, {0.02, 2}, {0.4, 2 + 0.38 * last}}}).kind;
    };
    EXPECT_EQ(steep(45), BreakoutKind::steady_slope);
    EXPECT_EQ(steep(55), BreakoutKind::still_rising);
}

TEST(BreakoutRule, TenPointsMakeACurve) {
    const Corners curve{{{0, 0}, {0.05, 1}, {0.2, 0.3}}};
    EXPECT_EQ(of(curve, 0.16, 0.02).kind, BreakoutKind::still_rising);
    EXPECT_EQ(of(curve, 0.18, 0.02).kind, BreakoutKind::zero_slope);
}

}  // namespace
}  // namespace sandgraph::results
