#include "packings/compressed_packings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "dem/make_assembly.hpp"
#include "dem/packing/observe.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::packings {
namespace {

scene::Grains few_grains() {
    scene::Grains grains;
    grains.count = 60;
    return grains;
}

TEST(PackingTraits, DescribeThePackingAtItsPressure) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    const CompressedPackings packings(few_grains());
    const graph::RowPacking row = packings.row(40e3);
    const stress::PackingTraits traits = packings.traits(row, 0.5);
    EXPECT_NEAR(traits.pressure, 40e3, 0.01 * 40e3);
    EXPECT_NEAR(traits.porosity, dem::porosity(packings.at(40e3)), 1e-9);
    EXPECT_NEAR(traits.porosity, 0.16, 0.01);
    EXPECT_EQ(traits.bulk, row.moduli.bulk);
    EXPECT_EQ(traits.shear, row.moduli.shear);
    EXPECT_GT(traits.shear, 1e6);
    EXPECT_GT(traits.coordination, 2.5);
    EXPECT_LT(traits.coordination, 4.5);
    EXPECT_LT(std::hypot(traits.fabric_xx, traits.fabric_xy), 0.1);
    EXPECT_EQ(traits.peak_friction, std::sin(0.5));
}

// Also when the packing comes from the cache: both stresses have their own.
TEST(PackingTraits, OfAnisotropicGroundAreThoseOfItsMeanStress) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    const CompressedPackings packings(few_grains());
    const Mat2 isotropic = packings.row(40e3).packing->stress;
    for (int again = 0; again < 2; ++again) {
        const graph::RowPacking row = packings.row(40e3, 0.5);
        EXPECT_NEAR(row.packing->stress(0, 0), 20e3, 0.02 * 20e3);
        EXPECT_NEAR(row.packing->stress(1, 1), 40e3, 0.01 * 40e3);
        EXPECT_NEAR(packings.traits(row, 0.5).pressure, 30e3, 0.01 * 30e3);
        EXPECT_GT(row.moduli.shear, 1e6);
        EXPECT_NE(row.moduli.bulk, packings.row(40e3).moduli.bulk);
    }
    EXPECT_EQ(packings.row(40e3).packing->stress, isotropic);
}

// All lengths by a tenth, the depth too: an assembly with the same stresses, ten times as quick.
TEST(CompressedPackings, OfSmallGrainsAreThoseOfLargeOnesScaled) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    scene::Grains small = few_grains();
    small.radius_min /= 10, small.radius_max /= 10, small.material.depth /= 10;
    const graph::PlaneModuli large_moduli = CompressedPackings(few_grains()).row(40e3).moduli;
    const CompressedPackings packings(small);
    EXPECT_NEAR(dem::porosity(packings.at(40e3)), dem::porosity(CompressedPackings(few_grains()).at(40e3)),
                0.005);
    EXPECT_NEAR(packings.row(40e3).moduli.bulk, large_moduli.bulk, 0.2 * large_moduli.bulk);
}

// Contacts turn towards the compressed direction and are lost across it.
TEST(PackingTraits, FabricLeansToTheCompressedAxis) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    const CompressedPackings packings(few_grains());
    dem::Rve rve(packings.row(40e3).packing);
    dem::Workspace work;
    const double size = 5e-4;
    for (int step = 0; step < 30; ++step)
        rve.update((Mat2() << 1 + size, 0, 0, 1 - size).finished(), few_grains().material,
                   dem::rve_options({}, few_grains().material, rve.packing().grains->radius), work);
    const auto sheared = std::make_shared<dem::CompactPacking>(rve.packing());
    const stress::PackingTraits traits = packings.traits({sheared, {}}, 0.5);
    EXPECT_LT(traits.fabric_xx, -0.02);
    EXPECT_LT(std::abs(traits.fabric_xy), -traits.fabric_xx);
    // The deviator of a tensor of trace 1.
    EXPECT_NEAR(0.5 + traits.fabric_xx, dem::observe(rve, few_grains().material).fabric(0, 0), 1e-6);
}

TEST(CompressedPackings, HaveTheModuliThatProbingMeasures) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    const CompressedPackings packings(few_grains());
    const graph::PlaneModuli moduli = packings.row(40e3).moduli;
    const dem::Moduli measured =
        dem::small_strain_moduli(packings.at(40e3), few_grains().material, dem::fast_assemblies());
    EXPECT_NEAR(moduli.bulk, measured.bulk, 1e-9 * measured.bulk);
    EXPECT_NEAR(moduli.shear, measured.shear, 1e-9 * measured.shear);
    EXPECT_GT(std::abs(measured.bulk - measured.shear), 0.01 * measured.bulk);
}

// Loose sand reaches its peak late: the tests go on to a tenth of axial strain.
TEST(CompressedPackings, HaveTheFrictionOfTestsToATenthOfStrain) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    scene::Grains grains = few_grains();
    grains.density = "loose", grains.target_porosity = 0.2;
    const CompressedPackings packings(grains);
    const dem::GrainScale scale = dem::grain_scale(packings.base_packing(), grains.material);
    const auto measured = [&](double strain) {
        std::vector<dem::PeakFriction> peaks;
        for (const double pressure : dem::confining_pressures) {
            const auto sample = dem::fast_assemblies()(packings.base_packing(), grains.material);
            const dem::BiaxialTest test{.confining_pressure = pressure * scale.stiffness,
                                        .axial_strain = strain};
            peaks.push_back(dem::peak_friction(dem::run_biaxial(*sample, test, scale)));
        }
        return dem::friction_angle(peaks);
    };
    EXPECT_NEAR(packings.friction(), measured(0.1), 1e-12);
    EXPECT_GT(measured(0.1), measured(0.05));
}

}  // namespace
}  // namespace sandgraph::packings
