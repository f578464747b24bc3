#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stress/mohr_coulomb.hpp"
#include "stress/principal_return.hpp"

namespace sandgraph::stress {
namespace {

const MohrCoulombConstants sand{20e6, 0.3, std::numbers::pi / 6, 0, 0};

// Pressed from both sides in the plane: sigma_zz follows with 2 nu of it, far from failure.
TEST(OutOfPlaneStress, FollowsThePlaneSoThatEvenCompressionStaysElastic) {
    std::vector<std::int32_t> ids{0};
    std::vector<Mat2> F{Mat2::Identity() * (1 - 1e-5)};
    std::vector<Stress> stress(1);
    MohrCoulomb law(sand, {{-1e3, -1e3, 0}}, {-1e3});
    law.initialise({ids, F, stress, 0});
    for (int k = 0; k < 1000; ++k) law.update({ids, F, stress, 1});
    const ElasticConstants elastic = sand.elastic();
    const double e = 1000 * 1e-5;
    EXPECT_NEAR(stress[0].xx, -1e3 - 2 * (elastic.lame() + elastic.shear()) * e,
                2e-3 * std::abs(stress[0].xx));
    EXPECT_NEAR(stress[0].yy, stress[0].xx, 1e-6);
}

// Beyond it by a tenth of a per mille as well as by half.
TEST(ReturnToYield, EndsOnTheSurfaceHoweverLittleItWasPassed) {
    for (const double beyond : {1e-4, 1e-3, 1e-2, 0.5}) {
        const double s3 = -90e3 * (1 + beyond), s1 = -30e3;  // (1 + sin phi)/(1 - sin phi) = 3
        ASSERT_GT(yield(s1, s3, sand), 0);
        const Principal s = return_to_yield({s1, -50e3, s3}, sand);
        EXPECT_NEAR(yield(s[0], s[2], sand), 0, 1e-6) << beyond;
    }
    const Principal inside{-30e3, -50e3, -89e3};
    EXPECT_EQ(return_to_yield(inside, sand), inside);
}

}  // namespace
}  // namespace sandgraph::stress
