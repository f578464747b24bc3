#include "results/analytic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sandgraph::results {
namespace {

double rad(double degrees) { return degrees * std::numbers::pi / 180; }
const double dense = rad(30.2), loose = rad(20.9);

TEST(Rankine, ActiveAndPassiveAreReciprocalAndKnownAt30Degrees) {
    EXPECT_NEAR(rankine_active(rad(30)), 1.0 / 3, 1e-12);
    EXPECT_NEAR(rankine_active(loose) * rankine_passive(loose), 1, 1e-12);
    EXPECT_EQ(rankine_passive(0), rankine_active(0));
}

TEST(WhiteCheukBolton, IsTheFrictionBlockWhateverTheDilationUnderEqualStresses) {
    for (const double psi : {0.0, 7.0, 14.0, 32.8})
        EXPECT_NEAR(white_cheuk_bolton(3, rad(32.8), rad(psi), 1), 1 + 3 * std::tan(rad(32.8)), 1e-12) << psi;
    // With psi = phi the planes stand at phi, and the stress at rest on them does not matter.
    EXPECT_NEAR(white_cheuk_bolton(3, rad(30), rad(30), 0.4), 1 + 3 * std::tan(rad(30)), 1e-12);
}

TEST(WhiteCheukBolton, OfLessHorizontalStressIsLess) {
    EXPECT_NEAR(white_cheuk_bolton(3, rad(32.8), rad(14), 1 - std::sin(rad(32.8))), 2.329, 1e-3);
    // psi = 0: vertical planes under K0 sigma_v.
    EXPECT_NEAR(white_cheuk_bolton(2, rad(30), 0, 0.5), 1 + 2 * 0.5 * std::tan(rad(30)), 1e-12);
}

TEST(MeyerhofAdams, BranchesMeetAtTheCriticalDepthWithOneSlope) {
    const double H = 4, h = 1e-6;
    const auto N = [&](double ratio) { return meyerhof_adams(ratio, dense, H); };
    EXPECT_NEAR(N(H - h), N(H + h), 1e-5);
    EXPECT_NEAR((N(H) - N(H - h)) / h, (N(H + h) - N(H)) / h, 1e-5);
}

TEST(MeyerhofAdams, DeepPlateTendsToTwiceTheCriticalSideResistance) {
    const double side = nominal_uplift_coefficient * std::tan(dense);
    EXPECT_NEAR(meyerhof_adams(1e9, dense, 4), 2 * 4 * side + 1, 1e-6);
    EXPECT_NEAR(meyerhof_adams(0, dense), 1, 1e-12);  // only the soil's own weight
}

TEST(MeyerhofAdams, TableIsInterpolatedAndHeldConstantBeyondItsEnds) {
    EXPECT_DOUBLE_EQ(critical_embedment_table(rad(30)), 4);
    EXPECT_NEAR(critical_embedment_table(rad(37.5)), 6, 1e-12);
    EXPECT_DOUBLE_EQ(critical_embedment_table(rad(10)), 2.5);
    EXPECT_DOUBLE_EQ(critical_embedment_table(rad(50)), 9);
}

TEST(MeyerhofAdams, GivesTheWorkedValues) {
    EXPECT_NEAR(meyerhof_adams(3, dense), 2.66, 0.005);
    EXPECT_NEAR(meyerhof_adams(5, dense), 3.76, 0.005);
    EXPECT_NEAR(meyerhof_adams(3, loose), 2.09, 0.005);
    EXPECT_NEAR(meyerhof_adams(5, loose), 2.81, 0.005);
}

TEST(Biarez, VanishesAtTheSurfaceAndRisesToItsLimit) {
    EXPECT_EQ(biarez(1, dense), 0);
    EXPECT_EQ(biarez(0.5, dense), 0);
    EXPECT_NEAR(biarez(1e9, dense), 4 * std::numbers::pi * std::tan(dense), 1e-6);
}

TEST(Biarez, GivesTheWorkedValues) {
    const double ratios[] = {2, 3, 5, 8}, at_dense[] = {3.66, 4.88, 5.85, 6.40},
                 at_loose[] = {2.40, 3.20, 3.84, 4.20};
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(biarez(ratios[k], dense), at_dense[k], 0.005);
        EXPECT_NEAR(biarez(ratios[k], loose), at_loose[k], 0.005);
    }
}

}  // namespace
}  // namespace sandgraph::results
