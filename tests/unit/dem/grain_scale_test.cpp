#include "dem/grain_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "dem/make_assembly.hpp"
#include "dem/prepare/prepare.hpp"
#include "dem/time_step.hpp"

namespace sandgraph::dem {
namespace {

TEST(PreparationStep, IsTheUsualOneOfUsualGrainsAndStaysStableForOthers) {
    const std::vector<double> usual{0.003, 0.007}, small{0.0003, 0.0007}, uneven{0.0002, 0.05, 0.05};
    EXPECT_EQ(grain_scale(usual, {}).time_step, 1e-5);
    Material stiff;
    stiff.young *= 20;
    EXPECT_LT(grain_scale(usual, stiff).time_step, 0.5 * critical_time_step(stiff, usual));
    EXPECT_LT(grain_scale(small, {}).time_step, 0.5 * critical_time_step({}, small));
    EXPECT_LT(grain_scale(uneven, {}).time_step, 0.5 * critical_time_step({}, uneven));
}

TEST(GrainScale, OfTableOneGrainsIsOneHoweverTheyAreDrawn) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        const GrainScale scale = grain_scale(random_gas({.seed = seed, .count = 50}), {});
        EXPECT_EQ(scale.slowness, 1);
        EXPECT_EQ(scale.stiffness, 1);
        EXPECT_EQ(scale.time_step, 1e-5);
    }
}

TEST(GrainScale, InertialNumberIsThatOfTheGrainsAtHand) {
    Material heavy;
    heavy.density = 1e6;
    const std::vector<double> gravel{0.03, 0.07};
    EXPECT_DOUBLE_EQ(inertial_number(0.1, 64e3, grain_scale(gravel, heavy)),
                     0.1 * 0.1 * std::sqrt(1e6 / 64e3));
    EXPECT_EQ(inertial_number(0.1, 0, grain_scale(gravel, heavy)), 0);
}

// Grains of one shape: all lengths times `length`, mass and stiffness per volume times `density`, `young`.
struct Grains {
    Recipe recipe{.count = 60, .radius_min = 0.0015, .radius_max = 0.0035, .tolerance = 0.02};
    Material material;
    Grains(double length, double density, double young) {
        recipe.radius_min *= length, recipe.radius_max *= length;
        recipe.consolidation_pressure *= young;
        material.depth *= length, material.density *= density, material.young *= young;
    }
};

Packing made(const Grains& g) { return prepare(g.recipe, g.material, fast_assemblies()).packing; }

// Powers of two, so that rounding scales along.
constexpr double kLength = 4, kDensity = 4, kYoung = 16;

TEST(GrainScale, ScaledGrainsMakeTheScaledPackingWithItsModuli) {
    const Grains small(1, 1, 1), large(kLength, kDensity, kYoung);
    const Packing a = made(small), b = made(large);
    EXPECT_NEAR(porosity(b), porosity(a), 1e-12);
    EXPECT_NEAR(b.H(0, 0) / a.H(0, 0), kLength, 1e-9);
    const Moduli soft = small_strain_moduli(a, small.material, fast_assemblies()),
                 stiff = small_strain_moduli(b, large.material, fast_assemblies());
    EXPECT_NEAR(stiff.bulk / soft.bulk, kYoung, 1e-6 * kYoung);
    EXPECT_NEAR(stiff.shear / soft.shear, kYoung, 1e-6 * kYoung);
}

std::vector<BiaxialRow> biaxial(const Packing& packing, const Material& material) {
    const auto sample = fast_assemblies()(packing, material);
    return run_biaxial(*sample, {.axial_strain = 0.004}, grain_scale(packing, material));
}

TEST(GrainScale, TestsOfScaledGrainsSayTheSame) {
    const Grains small(1, 1, 1), large(kLength, kDensity, kYoung);
    const std::vector<BiaxialRow> a = biaxial(made(small), small.material),
                                  b = biaxial(made(large), large.material);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].step, b[k].step);
        EXPECT_NEAR(b[k].p / a[k].p, kYoung, 1e-6 * kYoung);
        EXPECT_NEAR(b[k].sin_phi, a[k].sin_phi, 1e-6);
        EXPECT_NEAR(b[k].volumetric_strain, a[k].volumetric_strain, 1e-9);
        EXPECT_NEAR(b[k].inertial_number, a[k].inertial_number, 1e-6 * a[k].inertial_number);
    }
    EXPECT_GT(a.back().sin_phi, 0.2);
}

}  // namespace
}  // namespace sandgraph::dem
