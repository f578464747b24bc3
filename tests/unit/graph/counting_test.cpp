#include <gtest/gtest.h>

#include "tests/unit/graph/screening_bench.hpp"

namespace sandgraph::graph {
namespace {

Mat2 of(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }

TEST(RveCounters, CountAPredictionOnlyWhereTheGroundHasUsedOne) {
    RveCounters counters;
    counters.count({dem::RveStatus::ok, 5, 0.1}, false, 0.5);
    EXPECT_EQ(counters.predicted, 0);
    EXPECT_EQ(counters.prediction_error_sum, 0);
    counters.count({dem::RveStatus::diverged, 7, 0.05}, true, 0.25);
    EXPECT_EQ(counters.predicted, 1);
    EXPECT_EQ(counters.prediction_error_sum, 0.25);
    EXPECT_EQ(counters.dem_steps, 12);
    EXPECT_EQ(counters.failures, 1);
    EXPECT_EQ(counters.inertial_number_max, 0.1);
}

TEST(RveLawSetup, TheTimeStepFollowsTheStiffestRow) {
    RveLawSetup setup;
    setup.packings = {{nullptr, {4, 3}}, {nullptr, {2, 1}}};
    EXPECT_EQ(setup.p_wave_modulus(), 7);
}

TEST(Visits, CollectIncrementsInTheirOrder) {
    const Mat2 first = of(1.01, 0.02, 0, 1), second = of(1, 0, 0.03, 0.99);
    Visits visits(1);
    Stress s{-1e5, -1e5, 0};
    for (const Mat2& F : {first, second}) visits.predict(0, {1, 1}, F, false, {}, 1000, s);
    EXPECT_LT((visits.collected(0) - second * first).norm(), 1e-15);
}

TEST(StrainPath, KeepsACornerThatLiesFurtherOffThanItsTolerance) {
    for (const double off : {0.5e-5, 1.5e-5}) {
        StrainPath path(1e-5);
        path.add(of(1 + off, 1e-3, 0, 1)), path.add(of(1, 2e-3, 0, 1));
        EXPECT_EQ(path.knots(), off > 1e-5 ? 1u : 0u);
    }
}

}  // namespace
}  // namespace sandgraph::graph
