#include <gtest/gtest.h>

#include "dem/element_test/element_test.hpp"
#include "dem/element_test/servo.hpp"
#include "dem/packing/csv.hpp"
#include "dem/reference/reference.hpp"
#include "tests/unit/dem/yade_reference.hpp"

namespace sandgraph::dem {
namespace {

constexpr double degree = std::numbers::pi / 180;

ReferenceAssembly sample(const std::string& kind) {
    return {read_packing_csv(test::yade_file("packing_" + kind + "_p10.csv")), Material{}};
}

std::vector<BiaxialRow> biaxial(const std::string& kind, double pressure, double strain) {
    ReferenceAssembly assembly = sample(kind);
    return run_biaxial(assembly, {.confining_pressure = pressure, .axial_strain = strain},
                       grain_scale(assembly.packing(), Material{}));
}

std::vector<BiaxialRow> yade_biaxial(const std::string& kind, int kilopascal) {
    const test::Table t = test::read_table("biaxial_" + kind + "_" + std::to_string(kilopascal) + "kPa.csv");
    std::vector<BiaxialRow> rows(t.rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].axial_strain = t.at(k, "eps_a");
        rows[k].p = t.at(k, "p"), rows[k].q = t.at(k, "q"), rows[k].sin_phi = t.at(k, "sin_phi");
    }
    return rows;
}

double rms_error(const std::vector<BiaxialRow>& rows, double pressure) {
    double sum = 0;
    for (const BiaxialRow& row : rows) sum += std::pow(row.seen.stress(0, 0) / pressure - 1, 2);
    return std::sqrt(sum / static_cast<double>(rows.size()));
}

TEST(StressServo, BringsAnElasticSpringToItsTargetUnderSteadyDisturbance) {
    constexpr double modulus = 1e7, dt = 1e-5, disturbance = -3e5;  // Pa, s, Pa/s
    StressServo servo(modulus, 1e-4, 1e-3, 5);
    double stress = 0;
    for (int k = 0; k < 2000; ++k) stress += dt * (modulus * servo.rate(1000 - stress, dt) + disturbance);
    EXPECT_NEAR(stress, 1000, 1e-3);
}

TEST(StressServo, NeverExceedsItsRate) {
    StressServo servo(1e7, 1e-4, 1e-3, 0.5);
    EXPECT_EQ(servo.rate(1e9, 1e-3), 0.5);
    EXPECT_EQ(servo.rate(-1e9, 1e-3), -0.5);
}

TEST(Isotropic, BothNormalStressesReachThePressureAndStay) {
    ReferenceAssembly assembly = sample("dense");
    const auto rows =
        run_isotropic(assembly, {.pressure = 32e3}, grain_scale(assembly.packing(), Material{}));
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(rows.back().seen.stress(k, k), 32e3, 32);
    EXPECT_NEAR(rows.back().seen.porosity, 0.160562, 2e-5);  // YADE's
}

TEST(Isotropic, SaysWhenThePressureIsNotReached) {
    ReferenceAssembly assembly = sample("dense");
    EXPECT_THROW(run_isotropic(assembly, {.pressure = 1e6, .max_steps = 1000},
                               grain_scale(assembly.packing(), Material{})),
                 std::runtime_error);
}

TEST(Biaxial, ServoHoldsTheConfiningPressureTo02Percent) {
    EXPECT_LT(rms_error(biaxial("dense", 32e3, 0.03), 32e3), 2e-3);
    EXPECT_LT(rms_error(biaxial("loose", 64e3, 0.03), 64e3), 2e-3);
}

TEST(Biaxial, FollowsYadeAtSmallStrain) {
    const test::Table t = test::read_table("biaxial_dense_64kPa.csv");
    const auto rows = biaxial("dense", 64e3, 0.005);
    ASSERT_EQ(rows.size(), 11u);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        SCOPED_TRACE(k);
        EXPECT_NEAR(rows[k].axial_strain, t.at(k, "eps_a"), 5e-6);
        EXPECT_NEAR(rows[k].volumetric_strain, t.at(k, "eps_v"), 2e-5);
        EXPECT_NEAR(rows[k].p, t.at(k, "p"), 0.01 * t.at(k, "p"));
        EXPECT_NEAR(rows[k].q, t.at(k, "q"), 0.01 * t.at(k, "p"));
        EXPECT_NEAR(rows[k].inertial_number, t.at(k, "I"), 0.01 * t.at(k, "I"));
    }
}

TEST(Biaxial, DenseSandDilatesAndPeaksAsInYade) {
    const auto rows = biaxial("dense", 64e3, 0.1);
    EXPECT_LT(rows.back().volumetric_strain, -0.01);
    EXPECT_NEAR(peak_friction(rows).friction_angle, 31.6 * degree, 1 * degree);
}

TEST(Strength, PeaksAndLineOfTheYadeFilesAreThePublishedOnes) {
    const double published[2][3] = {{31.1, 31.6, 31.9}, {22.5, 23.3, 21.1}}, line[2] = {31.8, 21.7};
    const std::string kinds[2] = {"dense", "loose"};
    const int pressures[3] = {32, 64, 128};
    for (int kind = 0; kind < 2; ++kind) {
        std::vector<PeakFriction> peaks;
        for (int k = 0; k < 3; ++k) {
            peaks.push_back(peak_friction(yade_biaxial(kinds[kind], pressures[k])));
            EXPECT_NEAR(peaks.back().friction_angle / degree, published[kind][k], 0.06);
        }
        EXPECT_NEAR(friction_angle(peaks) / degree, line[kind], 0.06);
    }
}

TEST(Strength, LooksOnlyAtTheGivenStrain) {
    std::vector<BiaxialRow> rows(3);
    for (int k = 0; k < 3; ++k) {
        rows[k].axial_strain = 0.05 * k;
        rows[k].sin_phi = 0.1 * (k + 1), rows[k].p = 1000, rows[k].q = 100.0 * (k + 1);
    }
    EXPECT_EQ(peak_friction(rows, 0.06).friction_angle, std::asin(0.2));
    EXPECT_EQ(peak_friction(rows).friction_angle, std::asin(rows[2].sin_phi));
}

}  // namespace
}  // namespace sandgraph::dem
