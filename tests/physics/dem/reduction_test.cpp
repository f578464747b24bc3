#include "dem/fast/neighbours.hpp"
#include "dem/packing/observe.hpp"
#include "public_packing.hpp"

namespace sandgraph::dem {
namespace {

using test::matrix;

Mat2 stress_of(const Packing& p) { return love_weber_stress(p, contact_forces(p, {}), {}); }

// Wherever the cell of a long shear is due for re-reduction, the packing is taken over into the reduced basis
// and compared with itself before.
TEST(CellReduction, NoReductionOfALongShearIsFeltInTheStress) {
    FastAssembly sample(test::public_packing("dense"), {});
    const Mat2 shear = matrix(0, 4, 0, 0), step = Mat2::Identity() + test::dt * shear;
    int reductions = 0;
    bool was_due = false;
    double worst_now = 0, worst_next = 0;
    for (int k = 0; k < 125'000; ++k) {  // to gamma = 5
        sample.step(shear, test::dt, 1);
        const bool due = !reduce_cell(step * sample.cell()).identity, first = due && !was_due;
        was_due = due;
        if (!first) continue;
        const Packing before = sample.packing();
        FastAssembly reduced(before, {});
        const Packing after = reduced.packing();
        const Mat2 stress = stress_of(before);
        ASSERT_GT((after.H - before.H).norm(), 0.5 * before.H.norm());
        worst_now = std::max(worst_now, 2 * (stress_of(after) - stress).norm() / stress.trace());
        reduced.step(shear, test::dt, 1), sample.step(shear, test::dt, 1), ++k;
        worst_next = std::max(worst_next, 2 * (reduced.stress() - sample.stress()).norm() / stress.trace());
        ++reductions;
    }
    EXPECT_GE(reductions, 4);
    EXPECT_LT(worst_now, 1e-9);
    EXPECT_LT(worst_next, 1e-9);
    RecordProperty("reductions", reductions);
    RecordProperty("worst", std::to_string(1e12 * std::max(worst_now, worst_next)) + "e-12");
}

}  // namespace
}  // namespace sandgraph::dem
