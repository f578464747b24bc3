#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "report/run_report.hpp"

namespace sandgraph::report {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

results::FinishedRun run_of(double n_gamma, double friction_angle, bool breakout = true) {
    results::FinishedRun run;
    run.summary.n_gamma = n_gamma;
    run.summary.extra = {{"friction_angle_deg", friction_angle}};
    run.summary.breakout = breakout;
    return run;
}

TEST(BreakoutSeries, FrictionAngleIsTheMeanOfThoseThatAreKnown) {
    const auto series = breakout_series({run_of(2, 20), run_of(3, 30), run_of(4, kUnknown)});
    ASSERT_EQ(series.size(), 1u);
    EXPECT_NEAR(series[0].friction_angle, 25 * std::numbers::pi / 180, 1e-12);
    EXPECT_EQ(series[0].n_gamma, (std::vector<double>{2, 3, 4}));
    EXPECT_EQ(breakout_series({run_of(2, kUnknown)}).at(0).friction_angle, 0);
}

TEST(BreakoutSeries, LeavesOutRunsWhoseLoadStillRises) {
    const auto rising = run_of(2, 30, false);
    EXPECT_TRUE(breakout_series({rising}).empty());
    EXPECT_EQ(breakout_series({rising, run_of(3, 30)}).at(0).n_gamma, std::vector<double>{3});
}

}  // namespace
}  // namespace sandgraph::report
