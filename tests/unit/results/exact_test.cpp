#include "results/exact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace sandgraph::results {
namespace {

double deg(double angle) { return angle * std::numbers::pi / 180; }

// Values of the method of characteristics between the rows of the table, too.
TEST(Exact, FootingFactorsAreThoseOfTheCharacteristics) {
    EXPECT_NEAR(footing_factor(deg(30), true), 14.7543, 1e-4);
    EXPECT_NEAR(footing_factor(deg(40), false), 43.1866, 1e-4);
    EXPECT_NEAR(footing_factor(deg(32.8), true), 23.6030, 0.02);
    EXPECT_NEAR(footing_factor(deg(36), false), 20.9049, 0.02);
    EXPECT_NEAR(footing_factor(deg(42), true), 126.2033, 0.15);
    EXPECT_TRUE(std::isnan(footing_factor(deg(50), true)));
}

TEST(Exact, SurchargeWallsAndUplift) {
    EXPECT_NEAR(surcharge_factor(deg(30)), 18.4011, 1e-4);
    EXPECT_NEAR(passive_factor(deg(30)), 3, 1e-12);
    EXPECT_NEAR(active_factor(deg(30)), 1.0 / 3, 1e-12);
    EXPECT_NEAR(uplift_factor(3, deg(30)), 2.7321, 1e-4);
}

TEST(Exact, LimitIsTheMeanOfTheLastFifth) {
    const std::vector<double> d = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10},
                              load = {0, 9, 9, 9, 9, 9, 9, 9, 4, 5, 6};
    EXPECT_NEAR(limit_load(d, load), 5, 1e-12);
    EXPECT_TRUE(std::isnan(limit_load({}, {})));
}

}  // namespace
}  // namespace sandgraph::results
