#include "surrogate/coefficients.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random_model.hpp"

namespace sandgraph::surrogate {
namespace {

// Of outputs beyond all measure each coefficient stops at its own bound.
TEST(Coefficients, EachStopsAtItsOwnBound) {
    Model model = support::random_model(3, {1, 4, 8, 0});
    model.bounds = {2, 3, 5};
    const Member& m = model.members[0];
    const PointConstants point{20e3, 0.2, 24e6, 15e6, 3.6, 0.5};
    const CriticalPull none;
    const std::vector<double> most(13, 50), nothing(13, 0);
    const Coefficients usual = coefficients(model, m, point, 20e3, 1, none, nothing);
    const Coefficients bounded = coefficients(model, m, point, 20e3, 1, none, most);
    EXPECT_NEAR(usual.bulk, 24e6 * m.bulk, 1e-3);
    EXPECT_NEAR(bounded.bulk / usual.bulk, 5, 1e-9);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(usual.shear[k], 15e6 * m.share[k], 1e-3);
        EXPECT_NEAR(bounded.shear[k] / usual.shear[k], 2, 1e-9);
        EXPECT_NEAR(bounded.strength[k] / usual.strength[k], 3, 1e-9);
    }
}

TEST(ClampToTrained, CountsInWidthsOfTheRange) {
    std::array<FeatureRange, feature_count> ranges;
    ranges.fill({1, 3});
    Features x;
    x.fill(2);
    EXPECT_EQ(clamp_to_trained(ranges, x), 0);
    x[4] = 3.5;
    EXPECT_DOUBLE_EQ(clamp_to_trained(ranges, x), 0.25);
    EXPECT_EQ(x[4], 3);
    x[2] = 0;
    EXPECT_DOUBLE_EQ(clamp_to_trained(ranges, x), 0.5);
}

}  // namespace
}  // namespace sandgraph::surrogate
