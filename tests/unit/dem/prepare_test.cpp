#include "dem/prepare/prepare.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "dem/make_assembly.hpp"
#include "dem/packing/csv.hpp"
#include "dem/packing/observe.hpp"
#include "dem/prepare/stages.hpp"
#include "dem/reference/reference.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

std::unique_ptr<Assembly> reference(const Packing& p, const Material& m) {
    return std::make_unique<ReferenceAssembly>(p, m);
}

Observables look(const Packing& p) { return observe(p, contact_forces(p, Material{}), Material{}); }

// Few grains, so that the tests are quick; the porosity scatters more, hence the tolerance.
Recipe small(double porosity) {
    Recipe recipe;
    recipe.count = 100;
    recipe.target_porosity = porosity;
    recipe.tolerance = 0.006;
    return recipe;
}

Packing yade_dense() { return read_packing_csv(test::yade_file("packing_dense_p10.csv")); }

void expect_isotropic_rest(const Packing& p, double pressure, double tolerance) {
    const Observables seen = look(p);
    EXPECT_NEAR(seen.stress(0, 0), pressure, tolerance * pressure);
    EXPECT_NEAR(seen.stress(1, 1), pressure, tolerance * pressure);
    EXPECT_NEAR(seen.stress(0, 1), 0, tolerance * pressure);
    EXPECT_LT(seen.unbalanced, 1e-4);
    EXPECT_TRUE(p.vx.empty());
}

TEST(RandomGas, HasTheAskedRadiiAndPorosityAndNoContact) {
    Recipe recipe;
    recipe.gas_porosity = 0.5;
    const Packing gas = random_gas(recipe);
    EXPECT_EQ(gas.size(), 400u);
    EXPECT_NEAR(porosity(gas), 0.5, 1e-12);
    EXPECT_TRUE(contact_forces(gas, Material{}).empty());
    double mean = 0;
    for (double r : gas.r) {
        EXPECT_GE(r, 0.003);
        EXPECT_LE(r, 0.007);
        mean += r / 400;
    }
    EXPECT_NEAR(mean, 0.005, 2e-4);  // four standard deviations
}

TEST(RandomGas, IsDrawnFromSeedAndAttemptOnly) {
    Recipe recipe;
    EXPECT_EQ(random_gas(recipe).x, random_gas(recipe).x);
    EXPECT_NE(random_gas(recipe, 0).x, random_gas(recipe, 1).x);
    EXPECT_EQ(random_gas(recipe, 0).r, random_gas(recipe, 1).r);  // the same grains
    recipe.seed = 2;
    EXPECT_NE(random_gas(recipe).r, random_gas(Recipe{}).r);
}

TEST(RandomGas, RefusesImpossibleRecipes) {
    Recipe recipe;
    recipe.radius_min = -1;
    EXPECT_THROW(random_gas(recipe), InputError);
    recipe = Recipe{.count = 3};
    EXPECT_THROW(random_gas(recipe), InputError);
    recipe = Recipe{.consolidation_pressure = 0};
    EXPECT_THROW(random_gas(recipe), InputError);
    recipe = Recipe{.tolerance = std::nan("")};
    EXPECT_THROW(random_gas(recipe), InputError);
    recipe = Recipe{.gas_porosity = 0.1};
    EXPECT_THROW(random_gas(recipe), InputError);
}

TEST(Prepare, DenseAndLoosePackingsHaveTheirPorosityAndPressure) {
    for (const double target : {0.16, 0.20}) {
        const Prepared made = prepare(small(target), Material{}, reference);
        EXPECT_NEAR(made.porosity, target, 0.006);
        EXPECT_NEAR(porosity(made.packing), made.porosity, 1e-15);
        expect_isotropic_rest(made.packing, 10e3, 1e-3);
    }
}

TEST(Prepare, LooserSandNeedsMoreConsolidationFriction) {
    const Prepared dense = prepare(small(0.16), Material{}, reference);
    const Prepared loose = prepare(small(0.20), Material{}, reference);
    EXPECT_LT(dense.consolidation_friction, loose.consolidation_friction);
    EXPECT_GT(look(dense.packing).coordination, look(loose.packing).coordination);
}

TEST(Prepare, IsDeterministicAndTellsItsProgress) {
    std::vector<double> fractions;
    const ProgressCallback note = [&](std::string_view, double f) { fractions.push_back(f); };
    const Prepared a = prepare(small(0.20), Material{}, reference, note),
                   b = prepare(small(0.20), Material{}, reference);
    EXPECT_EQ(a.packing.x, b.packing.x);
    EXPECT_EQ(a.packing.H, b.packing.H);
    EXPECT_FALSE(fractions.empty());
    for (double f : fractions) EXPECT_TRUE(f >= 0 && f <= 1) << f;
}

TEST(Prepare, SaysWhenAPorosityIsOutOfReach) {
    Recipe recipe = small(0.05);
    recipe.count = 20;
    EXPECT_THROW(prepare(recipe, Material{}, reference), InputError);
}

class CompressTo : public testing::TestWithParam<double> {};

TEST_P(CompressTo, BringsThePackingToRestAtThePressure) {
    const Packing p = compress_to(yade_dense(), {.pressure = GetParam()}, Material{}, reference);
    expect_isotropic_rest(p, GetParam(), 1e-3);
    EXPECT_EQ(p.r, yade_dense().r);
}

INSTANTIATE_TEST_SUITE_P(UpAndDown, CompressTo, testing::Values(500.0, 2e3, 32e3, 1e6),
                         [](const auto& p) { return std::to_string(static_cast<int>(p.param)) + "_Pa"; });

class ConsolidateTo : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(ConsolidateTo, BringsBothStressesToTheirTargetsAtRest) {
    const auto [pressure, k0] = GetParam();
    const Packing p =
        compress_to(yade_dense(), {.pressure = pressure, .k0 = k0}, Material{}, fast_assemblies());
    const Observables seen = look(p);
    EXPECT_NEAR(seen.stress(1, 1), pressure, 1e-3 * pressure);
    EXPECT_NEAR(seen.stress(0, 0) / (k0 * pressure), 1, 0.005);
    EXPECT_NEAR(seen.stress(0, 1), 0, 1e-3 * pressure);
    EXPECT_LT(seen.unbalanced, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Ratios, ConsolidateTo,
                         testing::Values(std::pair(32e3, 0.5), std::pair(1e3, 0.5), std::pair(100e3, 0.4),
                                         std::pair(20e3, 2.0)));

TEST(ConsolidateTo, RefusesWhatNoFrictionHolds) {
    for (const double k0 : {0.1, 8.0})
        EXPECT_THROW(compress_to(yade_dense(), {.pressure = 32e3, .k0 = k0}, Material{}, fast_assemblies()),
                     InputError)
            << k0;
}

TEST(CompressTo, AgreesWithYadesPackingAt32kPa) {
    const Packing p = compress_to(yade_dense(), {.pressure = 32e3}, Material{}, reference);
    EXPECT_NEAR(porosity(p), 0.160562, 3e-5);
}

TEST(CompressTo, RefusesTension) {
    EXPECT_THROW(compress_to(yade_dense(), {.pressure = -1}, Material{}, reference), InputError);
}

TEST(CompressTo, RefusesWhatTheGrainsDoNotBear) {
    EXPECT_THROW(compress_to(yade_dense(), {.pressure = 4e6}, Material{}, reference), InputError);
    Material soft;
    soft.young /= 100;
    EXPECT_THROW(compress_to(yade_dense(), {.pressure = 40e3}, soft, reference), InputError);
}

TEST(CompressTo, WhatGrainsBearCanBeReadAgain) {
    Recipe recipe = small(0.20);
    const Packing loose = prepare(recipe, Material{}, fast_assemblies()).packing;
    const double most = bearable_pressure(grain_scale(loose, Material{}));
    const Packing pressed = compress_to(loose, {.pressure = most}, Material{}, fast_assemblies());
    EXPECT_GT(porosity(pressed), 0);
    EXPECT_NO_THROW(check_packing(pressed, {}));
}

TEST(Prepare, NamesTheDampingWhenGrainsRingOn) {
    Material ringing;
    ringing.damping = 0;
    try {
        prepare({.count = 20}, ringing, fast_assemblies());
        ADD_FAILURE() << "came to rest";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("grains.damping = 0"), std::string::npos) << error.what();
    }
}

TEST(SmallStrainModuli, BulkModulusIsTheSlopeOfIsotropicCompression) {
    const Packing p = compress_to(yade_dense(), {.pressure = 32e3}, Material{}, reference);
    const Packing q = compress_to(p, {.pressure = 34e3, .tolerance = 1e-4}, Material{}, reference);
    const double slope =
        (look(q).stress.trace() - look(p).stress.trace()) / 2 / std::log(p.area() / q.area());
    const Moduli moduli = small_strain_moduli(p, Material{}, reference);
    EXPECT_NEAR(moduli.bulk, slope, 0.05 * slope);
    EXPECT_GT(moduli.shear, 0.3 * moduli.bulk);
    EXPECT_EQ(moduli.p_wave, moduli.bulk + moduli.shear);
}

TEST(SmallStrainModuli, ScaleWithTheContactStiffness) {
    Material stiff;
    stiff.young *= 2;
    // Twice the stiffness at twice the pressure is the same packing.
    Packing p = compress_to(yade_dense(), {.pressure = 32e3}, Material{}, reference);
    const Moduli soft = small_strain_moduli(p, Material{}, reference);
    for (Contact& c : p.contacts) c.tangential *= 2, c.moment *= 2;
    const Moduli hard = small_strain_moduli(p, stiff, reference);
    EXPECT_NEAR(hard.bulk / soft.bulk, 2, 1e-3);
    EXPECT_NEAR(hard.shear / soft.shear, 2, 1e-3);
}

}  // namespace
}  // namespace sandgraph::dem
