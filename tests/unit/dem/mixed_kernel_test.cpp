#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "dem/fast/fast.hpp"
#include "dem/mixed/assembly.hpp"
#include "dem/mixed/kernel.hpp"
#include "dem/mixed/packing.hpp"
#include "dem/packing/csv.hpp"
#include "dem/packing/observe.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

Packing dense() { return read_packing_csv(test::yade_file("packing_dense_p32.csv")); }
Mat2 shear(double rate) { return (Mat2() << 0, rate, 0, 0).finished(); }
double relative(const Mat2& a, const Mat2& b) { return (a - b).norm() / b.norm(); }

Mat2 stress_after(Assembly& sample, const Mat2& L, int steps) {
    sample.step(L, 1e-5, steps);
    return sample.stress();
}

TEST(MixedKernel, StartsWithTheStressOfTheDoubleKernel) {
    MixedAssembly mixed(dense(), {});
    FastAssembly fast(dense(), {});
    EXPECT_LE(relative(stress_after(mixed, shear(0.4), 1), stress_after(fast, shear(0.4), 1)), 3e-6);
    EXPECT_LE(relative(stress_after(mixed, shear(0.4), 99), stress_after(fast, shear(0.4), 99)), 5e-5);
}

TEST(MixedKernel, KnowsBothRollingForms) {
    Material total;
    total.rolling_form = RollingForm::total;
    FastAssembly fast(dense(), total), other(dense(), {});
    MixedAssembly mixed(dense(), total);
    const Mat2 s = stress_after(fast, shear(1), 300);
    EXPECT_LE(relative(stress_after(mixed, shear(1), 300), s), 3e-4);
    EXPECT_GT(relative(stress_after(other, shear(1), 300), s), 1e-3);
}

TEST(MixedKernel, EveryInstructionSetOfTheMachineAgrees) {
    const auto stress = [] {
        MixedAssembly mixed(dense(), {});
        return stress_after(mixed, shear(1), 100);
    };
    const Mat2 widest = stress();
    for (const std::string& target : kernel_targets()) {
        use_kernel_target(target);
        EXPECT_LE(relative(stress(), widest), 2e-5) << target;
    }
    hwy::GetChosenTarget().DeInit();
}

TEST(MixedKernel, RepeatsItselfBitForBit) {
    MixedAssembly a(dense(), {}), b(dense(), {});
    a.step(shear(0.4), 1e-5, 3000);
    for (int part = 0; part < 3; ++part) b.step(shear(0.4), 1e-5, 1000);
    EXPECT_EQ(a.stress(), b.stress());
    EXPECT_EQ(a.packing().x, b.packing().x);
    EXPECT_GT(a.rebuilds(), 0);
}

TEST(MixedKernel, ShowsTheObservablesOfItsLastForces) {
    MixedAssembly mixed(dense(), {});
    mixed.step(shear(0.4), 1e-5, 2000);
    EXPECT_LE(relative(mixed.observe().stress, mixed.stress()), 1e-5);
}

// Forces cancel pair by pair but for the rounding of their sums.
TEST(MixedKernel, KeepsMomentum) {
    Material undamped;
    undamped.damping = 0;
    MixedAssembly mixed(dense(), undamped);
    mixed.step(Mat2::Zero(), 1e-5, 2000);
    const Packing q = mixed.packing();
    double px = 0, py = 0, scale = 0;
    for (std::size_t g = 0; g < q.size(); ++g) {
        const double m = q.r[g] * q.r[g];
        px += m * q.vx[g], py += m * q.vy[g], scale += m * std::hypot(q.vx[g], q.vy[g]);
    }
    EXPECT_GT(scale, 0);
    EXPECT_LE(std::hypot(px, py), 1e-4 * scale);
}

// Overlaps of a packing at 1 kPa are 1e-5 of a radius: less than a float resolves of a distance.
TEST(MixedKernel, ResolvesOverlapsThatFloatsDoNot) {
    Packing p = dense();
    p.H *= 10, p.x = {0.001, 0.011}, p.y = {0.7, 0.7}, p.r = {0.005, 0.0050000500}, p.contacts.clear();
    p.H = 0.5 * Mat2::Identity();
    for (const double overlap : {5e-8, 5e-9, 1e-9}) {
        p.x[1] = 0.001 + 0.005 + 0.00500005 - overlap;
        MixedAssembly mixed(p, {});
        mixed.step(Mat2::Zero(), 1e-9, 1);
        const double expected = 800e6 * 2 * p.r[0] * p.r[1] / (p.r[0] + p.r[1]) * overlap * 0.01 / 0.025;
        EXPECT_NEAR(mixed.stress()(0, 0), expected, (1e-9 / overlap * 0.3 + 1e-3) * expected) << overlap;
    }
}

// Every pair in reach is listed once, with its history; the cell and its basis do not matter.
TEST(MixedList, HoldsEveryPairInReachOnceWithItsHistory) {
    FastAssembly fast(dense(), {});
    fast.step(shear(0.4), 1e-5, 2000);
    const Packing p = fast.packing();
    MixedState s;
    MixedList list;
    load(p, {}, s, list);
    std::map<std::pair<int, int>, double> listed;
    for_each_pair(s.packing, [&](std::size_t slot, int i, int j) {
        EXPECT_TRUE(listed.insert({{std::min(i, j), std::max(i, j)}, s.packing.tangential[slot]}).second);
    });
    EXPECT_EQ(static_cast<int>(listed.size()), s.packing.pairs);
    const auto contacts = contact_forces(p, {});
    ASSERT_GT(contacts.size(), 500u);
    for (const ContactForce& c : contacts)
        EXPECT_EQ(listed.count({std::min(c.i, c.j), std::max(c.i, c.j)}), 1u);
    for (const Contact& c : p.contacts)
        EXPECT_EQ((listed[{std::min(c.i, c.j), std::max(c.i, c.j)}]), float(c.tangential));
}

TEST(MixedList, DealsPairsOutEvenly) {
    MixedState s;
    MixedList list;
    load(dense(), {}, s, list);
    int rows = 0;
    for (const int of_block : s.packing.rows) rows += of_block;
    const int loose = static_cast<int>(s.packing.loose_first.size()), dealt = s.packing.pairs - loose;
    EXPECT_LE(16 * rows, 1.2 * dealt);
    EXPECT_LT(loose, dealt / 3);
}

// A long shear with reductions of the cell and lists made anew meets every contact that a full search finds.
TEST(MixedList, MissesNoContactInALongShear) {
    MixedAssembly mixed(dense(), {});
    for (int part = 0; part < 40; ++part) {  // to a shear strain of 4
        mixed.step(shear(50), 1e-6, 2000);
        EXPECT_LE(relative(mixed.observe().stress, mixed.stress()), 1e-4) << part;
    }
    EXPECT_NEAR(mixed.cell().determinant(), dense().H.determinant(), 1e-9);
    EXPECT_GT(mixed.rebuilds(), 10);
}

TEST(MixedAssembly, RefusesAPackingOfTooFewGrains) {
    Packing p;
    p.H = 0.02 * Mat2::Identity();
    p.x = {0.001, 0.011}, p.y = {0.001, 0.011}, p.r = {0.005, 0.005};
    EXPECT_THROW(MixedAssembly(p, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sandgraph::dem
