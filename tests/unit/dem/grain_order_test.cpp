#include "dem/fast/packing.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

Packing dense() { return read_packing_csv(test::yade_file("packing_dense_p32.csv")); }

// 2 x 2 copies of a packing side by side: the same sand in a larger cell.
Packing four_copies(const Packing& p) {
    Packing out = p;
    out.x.clear(), out.y.clear(), out.r.clear(), out.vx.clear(), out.vy.clear(), out.spin.clear();
    out.contacts.clear(), out.H = 2 * p.H;
    for (int copy = 0; copy < 4; ++copy)
        for (std::size_t g = 0; g < p.size(); ++g) {
            const Vec2 shift = p.H * Vec2(copy / 2, copy % 2);
            out.x.push_back(p.x[g] + shift.x()), out.y.push_back(p.y[g] + shift.y());
            out.r.push_back(p.r[g]);
        }
    return out;
}

double mean_step(const Packing& p, const std::vector<int>& order) {
    double sum = 0;
    for (std::size_t k = 1; k < order.size(); ++k)
        sum += std::hypot(p.x[order[k]] - p.x[order[k - 1]], p.y[order[k]] - p.y[order[k - 1]]);
    return sum / static_cast<double>(order.size() - 1);
}

TEST(GrainOrder, IsAPermutationThatItsInverseUndoes) {
    const Packing p = dense();
    const std::vector<int> order = strip_order(p);
    const Packing back = reordered(reordered(p, order), inverse_order(order));
    EXPECT_EQ(back.x, p.x);
    EXPECT_EQ(back.r, p.r);
    ASSERT_EQ(back.contacts.size(), p.contacts.size());
    for (std::size_t c = 0; c < p.contacts.size(); ++c) EXPECT_EQ(back.contacts[c].j, p.contacts[c].j);
}

TEST(GrainOrder, BringsNeighboursTogether) {
    const Packing p = four_copies(dense());
    std::vector<int> as_given(p.size());
    for (std::size_t k = 0; k < p.size(); ++k) as_given[k] = static_cast<int>(k);
    EXPECT_LT(mean_step(p, strip_order(p)), 0.25 * mean_step(p, as_given));
}

TEST(FastKernel, FourCopiesOfACellAnswerLikeOne) {
    Packing one = dense();
    one.contacts.clear(), one.vx.clear(), one.vy.clear(), one.spin.clear();
    FastAssembly small(one, Material{}), large(four_copies(one), Material{});
    const Mat2 L = (Mat2() << 0, 0.4, 0, 0).finished();
    small.step(L, 1e-5, 100), large.step(L, 1e-5, 100);
    EXPECT_LE((small.stress() - large.stress()).norm(), 1e-9 * small.stress().norm());
}

TEST(FastKernel, GivesGrainsBackInTheOrderOfItsCaller) {
    const Packing before = four_copies(dense());
    FastAssembly fast(before, Material{});
    fast.step(Mat2::Zero(), 1e-6, 1);
    const Packing after = fast.packing();
    EXPECT_EQ(after.r, before.r);
    for (std::size_t g = 0; g < before.size(); ++g) {
        const Vec2 moved = fast.cell().inverse() * Vec2(after.x[g] - before.x[g], after.y[g] - before.y[g]);
        ASSERT_LE((moved - Vec2(std::round(moved.x()), std::round(moved.y()))).norm(), 1e-6) << g;
    }
}

}  // namespace
}  // namespace sandgraph::dem
