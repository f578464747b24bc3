#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "dem/element_test/element_test.hpp"
#include "dem/grain_scale.hpp"
#include "dem/rve.hpp"
#include "dem/stretch.hpp"
#include "dem/time_step.hpp"
#include "tests/support/public_packing.hpp"
#include "tests/support/table1_options.hpp"

// How many DEM steps an update takes, when a packing floats, and the figures that element tests give.
namespace sandgraph::dem {
namespace {

Mat2 of(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }
Mat2 stretched(double e) { return of(std::exp(e), 0, 0, std::exp(-e)); }  // Hencky norm sqrt(2) e

struct RveRules : testing::Test {
    RveReport update(const Mat2& F) { return rve.update(F, material, options, work); }
    double pressure() const { return 0.5 * rve.stress().trace(); }
    double diameter() const { return rve.packing().grains->mean_diameter; }

    Material material;
    RveOptions options = support::table1_options();
    Rve rve{support::public_packing().packing};
    Workspace work;
};

TEST_F(RveRules, TheMeanDiameterIsThatOfTheGrains) {
    double sum = 0;
    for (const double r : rve.packing().grains->radius) sum += 2 * r;
    EXPECT_NEAR(diameter(), sum / double(rve.packing().grains->radius.size()), 1e-12);
}

// I = rate d sqrt(rho/p).
TEST_F(RveRules, TheInertialNumberBoundsTheStrainOfAStep) {
    options.inertial_number_max = 1e-5;
    const double rate = 1e-5 * std::sqrt(pressure() / 2650) / diameter();
    EXPECT_NEAR(rve.strain_per_step(material, options), rate * options.time_step, 1e-9 * rate);
    options.pressure_floor = 4 * pressure();
    EXPECT_NEAR(rve.strain_per_step(material, options), 2 * rate * options.time_step, 1e-9 * rate);
    options.inertial_number_max = 1;
    EXPECT_NEAR(rve.strain_per_step(material, options), options.strain_per_step_max, 1e-15);
}

TEST_F(RveRules, AnUpdateTakesTheStepsThatItsStrainNeeds) {
    options.inertial_number_max = 1, options.strain_per_step_max = 1e-5, options.settle_steps = 0;
    EXPECT_EQ(update(stretched(1e-3)).dem_steps, 142);  // 100 sqrt(2)
    options.steps_min = 7;
    EXPECT_EQ(update(stretched(1e-6)).dem_steps, 7);
}

// Each step changes the elastic stress by a share of p at most, up to `settle_steps`.
TEST_F(RveRules, AShortUpdateIsDrivenInStepsOfItsStress) {
    options.inertial_number_max = 1, options.strain_per_step_max = 1, options.steps_min = 1;
    options.stress_per_step_max = 0.01, options.settle_steps = 10;
    const double strain = 0.045 * pressure() / options.modulus;
    EXPECT_EQ(update(stretched(strain / std::numbers::sqrt2)).dem_steps, 5);
    EXPECT_EQ(update(stretched(-10 * strain / std::numbers::sqrt2)).dem_steps, 10);
}

TEST_F(RveRules, TheReportTellsTheInertialNumberOfTheDrive) {
    options.inertial_number_max = 1, options.strain_per_step_max = 1e-5, options.settle_steps = 0;
    const double p = pressure();
    const RveReport report = update(stretched(1e-3));
    const double rate = std::sqrt(2.0) * 1e-3 / (report.dem_steps * options.time_step);
    EXPECT_NEAR(report.inertial_number, rate * diameter() * std::sqrt(2650 / p),
                2e-3 * report.inertial_number);
}

TEST_F(RveRules, FrameVolumeAndPorosityFollowTheDeformation) {
    const double start = rve.porosity();
    Mat2 F = Mat2::Identity();
    for (const double sign : {1.0, -1.0, 1.0}) {
        const Mat2 step = rotation(0.1) * of(1 + 2e-4, sign * 1e-4, sign * 1e-4, 1 - 1e-4);
        update(step);
        F = step * F;
    }
    EXPECT_NEAR(rve.angle(), 0.3, 1e-6);
    EXPECT_NEAR(rve.volume_ratio(), F.determinant(), 1e-12);
    EXPECT_NEAR(rve.porosity(), 1 - (1 - start) / F.determinant(), 1e-9);
}

// Opens evenly till it floats: at less than 10 Pa and half a per cent beyond the last contact.
TEST_F(RveRules, APackingFloatsHalfAPerCentBeyondItsLastContact) {
    double last_contact = 1;
    while (!rve.floating() && rve.volume_ratio() < 1.1) {
        update(of(1 + 2e-4, 0, 0, 1 + 2e-4));
        if (!rve.floating() && pressure() > options.float_pressure) last_contact = rve.volume_ratio();
    }
    ASSERT_TRUE(rve.floating());
    EXPECT_GE(rve.volume_ratio(), 1.005 * last_contact * (1 - 1e-9));
    EXPECT_LT(rve.volume_ratio(), 1.007 * last_contact);
    EXPECT_EQ(rve.stress(), Mat2(Mat2::Zero()));
    for (const float v : rve.packing().velocity) EXPECT_EQ(v, 0);
    const double n = rve.porosity(), J = rve.volume_ratio();
    EXPECT_EQ(update(of(1.02, 0, 0, 1)).dem_steps, 0);
    EXPECT_NEAR(rve.porosity(), 1 - (1 - n) / 1.02, 1e-9) << "what has opened up is in the porosity";
    EXPECT_NEAR(rve.volume_ratio(), 1.02 * J, 1e-12);
}

// Shear while it floats may raise the volume of contact, by 8 % at most.
TEST_F(RveRules, AFloatingPackingThatIsShearedIsLookedAtEarlier) {
    while (!rve.floating()) update(of(1 + 2e-4, 0, 0, 1 + 2e-4));
    options.inertial_number_max = 1, options.strain_per_step_max = 1e-3;  // only whether it is driven counts
    const double contact = rve.volume_ratio() / 1.005;
    const double open = 1.12 * contact / rve.volume_ratio();
    update(std::sqrt(open) * Mat2::Identity());
    for (int k = 0; k < 5; ++k) EXPECT_EQ(update(stretched(0.1)).dem_steps, 0) << "12 % open";
    int closing = 0;
    for (; closing < 20; ++closing)
        if (update(std::sqrt(0.99) * Mat2::Identity()).dem_steps > 0) break;
    EXPECT_GE(closing, 2) << "not before 8 % are left";
    EXPECT_LE(closing, 4);
}

// A packing that is strained one way for long may be driven faster, until it turns.
TEST_F(RveRules, BoundsLoosenWithTheStrainOneWayAndTightenAfterAReversal) {
    options.steady_factor = 2, options.steady_strain = 1e-3, options.inertial_number_max = 1;
    const double tight = options.strain_per_step_max;
    const auto drive = [&](double e, int times) {
        for (int k = 0; k < times; ++k) update(stretched(e));
        return rve.strain_per_step(material, options) / tight;
    };
    EXPECT_EQ(drive(2e-4, 3), 1);
    EXPECT_NEAR(drive(2e-4, 3), 1.4, 0.05) << "6 times 2.8e-4, the first of which has no way to go on yet";
    EXPECT_EQ(drive(2e-4, 8), 2) << "no further";
    EXPECT_EQ(drive(-2e-4, 1), 1);
    options.steady_factor = 1;
    EXPECT_EQ(drive(2e-4, 20), 1);
}

TEST_F(RveRules, NoiseIsNoWay) {
    options.steady_factor = 2, options.steady_strain = 1e-4, options.inertial_number_max = 1;
    for (int k = 0; k < 400; ++k) update(stretched(k % 2 ? 1e-6 : -1e-6));
    EXPECT_EQ(rve.strain_per_step(material, options), options.strain_per_step_max);
}

// At the stress that a step may change by a short update takes ten steps; what goes on as before needs none
// of them, what turns or goes three times as fast some or all.
TEST_F(RveRules, OnlyWhatChangesItsMotionSettles) {
    options.inertial_number_max = 1, options.strain_per_step_max = 1, options.steps_min = 1;
    options.stress_per_step_max = 1e-9, options.rate_jump_max = 2.1;
    const double e = 1e-6;
    EXPECT_EQ(update(stretched(e)).dem_steps, 10) << "from rest";
    EXPECT_EQ(update(stretched(e)).dem_steps, 5) << "twice as fast";
    EXPECT_EQ(update(stretched(e)).dem_steps, 3);
    EXPECT_EQ(update(stretched(-e)).dem_steps, 10) << "back";
    options.rate_jump_max = 0;
    EXPECT_EQ(update(stretched(-e)).dem_steps, 10) << "always";
}

TEST_F(RveRules, AnUpdateInPiecesReachesTheSameDeformation) {
    const Mat2 F = rotation(0.2) * of(1 + 1e-3, 4e-4, 2e-4, 1 - 5e-4),
               more = rotation(-0.1) * stretched(1e-4);
    options.inertial_number_max = 1;
    Rve whole(support::public_packing().packing);
    whole.update(F, material, options, work);
    const int all = whole.update(more, material, options, work).dem_steps;
    ASSERT_GT(all, 10);
    options.steps_max = 16;
    RveReport report = update(F);
    EXPECT_EQ(report.dem_steps, 16);
    EXPECT_TRUE(report.unfinished);
    report = update(more);  // new strain on top of the rest
    int pieces = 2;
    for (; report.unfinished && pieces < 50; ++pieces) report = update(Mat2::Identity());
    EXPECT_GE(pieces, 9);
    EXPECT_LE(pieces, 11);
    EXPECT_NEAR(rve.porosity(), whole.porosity(), 1e-13);
    EXPECT_NEAR(rve.volume_ratio(), whole.volume_ratio(), 1e-13);
    const auto strain = [](const Rve& r) {  // of the cell, which is not reduced over so little
        const Mat2 C = rotation(r.angle()) * r.packing().H;
        return Mat2(C * support::public_packing().packing->H.inverse());
    };
    EXPECT_LT((strain(rve) - strain(whole)).norm(), 1e-9);
}

// Settling is for what begins to move: else a bound below the ten steps of it would never let one end.
TEST_F(RveRules, TheRestOfAnUpdateDoesNotSettleAgain) {
    options.inertial_number_max = 1, options.strain_per_step_max = 1, options.steps_min = 1;
    options.stress_per_step_max = 1e-9, options.steps_max = 4;
    int steps = 0;
    RveReport report = update(stretched(1e-6));
    for (steps = report.dem_steps; report.unfinished && steps < 100; steps += report.dem_steps)
        report = update(Mat2::Identity());
    EXPECT_GE(steps, 10);
    EXPECT_LE(steps, 11);
}

// A packing that closes again after it has floated: the longest drives of all.
TEST_F(RveRules, AFloatingPackingComesBackInPieces) {
    while (!rve.floating()) update(of(1 + 2e-4, 0, 0, 1 + 2e-4));
    update(of(1.01, 0, 0, 1.01));
    options.steps_max = 50, options.inertial_number_max = 1;
    const double open = rve.porosity();
    RveReport report = update(of(0.98, 0, 0, 0.98));
    const double closed = rve.porosity();
    EXPECT_NEAR(1 - closed, (1 - open) / (0.98 * 0.98), 1e-12) << "what is not driven yet is seen";
    EXPECT_EQ(report.dem_steps, 50);
    EXPECT_TRUE(report.unfinished);
    EXPECT_FALSE(rve.floating());
    int pieces = 1;
    for (; report.unfinished && pieces < 1000; ++pieces) report = update(Mat2::Identity());
    EXPECT_GT(pieces, 20);
    EXPECT_FALSE(report.unfinished);
    EXPECT_GT(pressure(), 1000);
    EXPECT_NEAR(rve.porosity(), closed, 1e-9);
}

TEST(CriticalTimeStep, OfEqualDisksWithSixNeighboursIsClosedForm) {
    Material m;
    const std::vector<double> r{0.005, 0.005};
    const double mass = 2650 * 0.1 * std::numbers::pi * 0.005 * 0.005, k_n = 800e6 * 0.005, k_t = 0.5 * k_n;
    EXPECT_NEAR(critical_time_step(m, r), 2 / std::sqrt(6 * 4 * k_t / mass), 1e-12);
    m.rolling_stiffness = 3;
    EXPECT_NEAR(critical_time_step(m, r), 2 / std::sqrt(6 * 8 * k_t / mass), 1e-12);
    m.stiffness_ratio = 1e-3, m.rolling_stiffness = 0;  // it moves before it turns
    EXPECT_NEAR(critical_time_step(m, r), 2 / std::sqrt(6 * 1.001 * k_n / mass), 1e-12);
}

TEST(CriticalTimeStep, TheSmallestDiskBesideTheLargestDecides) {
    Material m;
    m.stiffness_ratio = 1e-6;
    const std::vector<double> r{0.006, 0.003, 0.005};
    const double mass = 2650 * 0.1 * std::numbers::pi * 9e-6, k_n = 800e6 * 2 * 0.003 * 0.006 / 0.009;
    const double contacts = std::numbers::pi / std::asin(0.006 / 0.009);
    EXPECT_NEAR(critical_time_step(m, r), 2 / std::sqrt(contacts * k_n / mass), 1e-10);
    const std::vector<double> uneven{0.006, 0.0003, 0.005};
    EXPECT_NEAR(grain_scale(uneven, m).time_step, 0.4 * critical_time_step(m, uneven), 1e-15);
}

TEST(GrainScale, ModulusIsTheNormalStiffnessOfTwoMeanGrainsOverTwiceTheDepth) {
    Material m;
    m.depth = 0.2;
    EXPECT_NEAR(grain_scale(std::vector<double>{0.004, 0.006}, m).modulus, 800e6 * 0.005 / 0.4, 1e-3);
}

BiaxialRow row(double strain, double sin_phi) {
    BiaxialRow r;
    r.axial_strain = strain, r.sin_phi = sin_phi, r.p = 1000, r.q = 1000 * sin_phi;
    return r;
}

TEST(PeakFriction, IsTheLargestWithinTheStrain) {
    const std::vector<BiaxialRow> rows{row(0, 0.1), row(0.02, 0.5), row(0.04, 0.5), row(0.1, 0.45),
                                       row(0.11, 0.9)};
    const PeakFriction peak = peak_friction(rows);
    EXPECT_EQ(peak.axial_strain, 0.02);
    EXPECT_NEAR(peak.friction_angle, std::asin(0.5), 1e-12);
    EXPECT_EQ(peak.q, 500);
}

TEST(FrictionAngle, IsALineThroughTheOriginByLeastSquares) {
    const std::vector<PeakFriction> peaks{{0, 1000, 500, 0}, {0, 2000, 800, 0}};
    EXPECT_NEAR(friction_angle(peaks), std::asin((1000.0 * 500 + 2000.0 * 800) / (1e6 + 4e6)), 1e-12);
    EXPECT_EQ(friction_angle({}), 0);
}

TEST(Stretch, LogarithmAndRootAreThoseOfThePrincipalStretches) {
    const Mat2 R = rotation(0.4), U = R * of(1.3, 0, 0, 0.9) * R.transpose();
    EXPECT_LT((hencky(U) - R * of(std::log(1.3), 0, 0, std::log(0.9)) * R.transpose()).norm(), 1e-14);
    const Mat2 third = root(U, 3);
    EXPECT_LT((third * third * third - U).norm(), 1e-14);
    const Polar parts = polar(rotation(2.5) * U);
    EXPECT_NEAR(parts.angle, 2.5, 1e-14);
    EXPECT_LT((parts.U - U).norm(), 1e-14);
}

}  // namespace
}  // namespace sandgraph::dem
