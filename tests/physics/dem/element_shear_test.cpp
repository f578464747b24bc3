#include <gtest/gtest.h>

#include <cmath>

#include "dem/element_test/element_test.hpp"
#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "tests/unit/dem/yade_reference.hpp"

namespace sandgraph::dem {
namespace {

std::vector<ShearRow> sheared(const std::string& density, double strain) {
    const Packing packing = read_packing_csv(test::yade_file("packing_" + density + "_p32.csv"));
    FastAssembly sample(packing, Material{});
    return run_shear(sample,
                     {.mean_stress = 20e3, .shear_rate = 0.5, .shear_strain = strain, .strain_every = 0.01},
                     grain_scale(packing, Material{}));
}

TEST(SimpleShear, HoldsTheMeanStressAndReachesItsStrain) {
    const auto rows = sheared("dense", 0.3);
    EXPECT_NEAR(rows.back().shear_strain, 0.3, 2e-3);
    double error = 0;
    for (const ShearRow& row : rows) error += std::pow(row.p / 20e3 - 1, 2);
    EXPECT_LE(std::sqrt(error / static_cast<double>(rows.size())), 0.01);
    EXPECT_NEAR(rows.back().inertial_number, 0.5 * 0.01 * std::sqrt(2650 / 20e3), 1e-4);
}

TEST(SimpleShear, DenseSandPeaksAndDilatesWhereLooseSandDoesNot) {
    const auto dense = sheared("dense", 0.3), loose = sheared("loose", 0.3);
    const auto highest = [](const std::vector<ShearRow>& rows) {
        double ratio = 0;
        for (const ShearRow& row : rows) ratio = std::max(ratio, row.stress_ratio);
        return ratio;
    };
    EXPECT_GT(highest(dense), highest(loose) + 0.05);
    EXPECT_LT(dense.back().volumetric_strain, -0.02);
    EXPECT_GT(loose.back().volumetric_strain, -0.01);
}

}  // namespace
}  // namespace sandgraph::dem
