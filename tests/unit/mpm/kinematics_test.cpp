#include "mpm/kinematics.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "base/random.hpp"

namespace sandgraph::mpm {
namespace {

Mat2 turned(double angle) {
    return (Mat2() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
}

Mat2 random_stretch(Random& random) {
    const Mat2 Q = turned(random.uniform(-3, 3));
    const Vec2 lengths(random.uniform(0.3, 3), random.uniform(0.3, 3));
    return Q * lengths.asDiagonal() * Q.transpose();
}

TEST(Kinematics, RigidRotationHasNoStrain) {
    for (const double angle : {-3.0, -0.7, 0.0, 0.4, 1.5, 3.1}) {
        EXPECT_NEAR(rotation(turned(angle)), angle, 1e-14);
        EXPECT_NEAR(equivalent_strain(turned(angle)), 0, 1e-12);
        EXPECT_NEAR(volumetric_strain(turned(angle)), 0, 1e-14);
    }
}

TEST(Kinematics, PolarDecompositionIsRecoveredFromItsProduct) {
    Random random(7);
    for (int k = 0; k < 200; ++k) {
        const double angle = random.uniform(-3.1, 3.1);
        const Mat2 U = random_stretch(random), F = turned(angle) * U;
        EXPECT_NEAR(rotation(F), angle, 1e-12);
        EXPECT_NEAR(equivalent_strain(F), equivalent_strain(U), 1e-12);
        EXPECT_NEAR(logarithmic_strain(F).trace(), std::log(F.determinant()), 1e-12);
    }
}

TEST(Kinematics, StrainIsObjective) {
    Random random(8);
    for (int k = 0; k < 50; ++k) {
        const Mat2 F = turned(0.3) * random_stretch(random), Q = turned(random.uniform(-3, 3));
        EXPECT_NEAR((logarithmic_strain(Q * F) - logarithmic_strain(F)).norm(), 0, 1e-12);
        const Mat2 rotated = Q * logarithmic_strain(F) * Q.transpose();
        EXPECT_NEAR((logarithmic_strain(F * Q.transpose()) - rotated).norm(), 0, 1e-12);
    }
}

TEST(Kinematics, PureShearAndUniaxialStrainHaveTheirClosedForm) {
    const double e = 0.4;
    const Mat2 shear = Vec2(std::exp(e), std::exp(-e)).asDiagonal(),
               uniaxial = Vec2(std::exp(-e), 1).asDiagonal();
    EXPECT_NEAR(equivalent_strain(shear), 2 / std::sqrt(3) * e, 1e-13);
    EXPECT_NEAR(equivalent_strain(uniaxial), 2.0 / 3 * e, 1e-13);
    EXPECT_NEAR(volumetric_strain(uniaxial), -e, 1e-14);
}

TEST(Kinematics, SmallSimpleShearTendsToTheLinearMeasures) {
    const double gamma = 1e-4;
    const Mat2 F = (Mat2() << 1, gamma, 0, 1).finished();
    EXPECT_NEAR(equivalent_strain(F), gamma / std::sqrt(3), 1e-8);
    EXPECT_NEAR(rotation(F), -gamma / 2, 1e-8);
}

TEST(Kinematics, InvertedPointGivesNaN) {
    const Mat2 F = Vec2(1, -1).asDiagonal();
    EXPECT_TRUE(std::isnan(equivalent_strain(F)));
    EXPECT_TRUE(std::isnan(rotation(F)));
    EXPECT_TRUE(std::isnan(volumetric_strain(F)));
}

}  // namespace
}  // namespace sandgraph::mpm
