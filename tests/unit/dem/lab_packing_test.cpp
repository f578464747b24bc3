#include "dem/rve.hpp"

#include <gtest/gtest.h>

#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "dem/packing/observe.hpp"
#include "dem/stretch.hpp"
#include "tests/support/table1_options.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

// Contact forces of the packing as shown must carry the stress that the RVE answers, in the lab frame.
TEST(LabPacking, CarriesTheStressOfItsRve) {
    FastAssembly a(read_packing_csv(test::yade_file("packing_dense_p32.csv")), Material{});
    a.step(Mat2::Zero(), 1e-5, 4000);
    Rve rve(compact(a.packing(), Material{}, a.stress()));
    Workspace work;
    const Mat2 shear = rotation(0.02) * (Mat2() << 1, 0.001, 0, 0.9998).finished();
    for (int k = 0; k < 40; ++k)
        ASSERT_EQ(rve.update(shear, Material{}, support::table1_options(), work).status, RveStatus::ok);
    ASSERT_GT(std::abs(rve.angle()), 0.5);
    const Packing shown = lab_packing(rve);
    const Mat2 stress = love_weber_stress(shown, contact_forces(shown, Material{}), Material{});
    EXPECT_GT(std::abs(stress(0, 1)), 0.05 * stress.trace());
    EXPECT_LT((stress - rve.stress()).norm(), 1e-2 * rve.stress().norm());
    EXPECT_NEAR(porosity(shown), rve.porosity(), 1e-9);
}

}  // namespace
}  // namespace sandgraph::dem
