#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>

#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "dem/packing/observe.hpp"
#include "dem/reference/reference.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

using test::yade_file;

Packing dense() { return read_packing_csv(yade_file("packing_dense_p32.csv")); }
Mat2 shear(double rate) { return (Mat2() << 0, rate, 0, 0).finished(); }

// Smallest distance of two centres modulo the cell, since the fast kernel wraps its grains.
double periodic_distance(const Mat2& H, const Vec2& a, const Vec2& b) {
    double best = 1e300;
    for (int image = 0; image < 25; ++image)
        best = std::min(best, (a - b + H * Vec2(image / 5 - 2, image % 5 - 2)).norm());
    return best;
}

TEST(FastKernel, MatchesTheReferenceStepOverAHundredSteps) {
    const Material material;
    ReferenceAssembly reference(dense(), material);
    FastAssembly fast(dense(), material);
    reference.step(shear(1), 1e-5, 100);
    fast.step(shear(1), 1e-5, 100);
    const Mat2 a = reference.stress(), b = fast.stress();
    EXPECT_LE((a - b).norm(), 1e-9 * a.norm());
    const Packing p = reference.packing(), q = fast.packing();
    for (std::size_t g = 0; g < p.size(); ++g)
        ASSERT_LE(periodic_distance(fast.cell(), {p.x[g], p.y[g]}, {q.x[g], q.y[g]}), 1e-9 * p.r[g]);
}

// Each instruction set rounds in its own order; nothing else may differ.
TEST(FastKernel, EveryInstructionSetOfTheMachineAgrees) {
    const auto stress_after_shear = [] {
        FastAssembly fast(dense(), Material{});
        fast.step(shear(1), 1e-5, 100);
        return fast.stress();
    };
    const Mat2 widest = stress_after_shear();
    const std::vector<std::string> targets = kernel_targets();
#if defined(__x86_64__) && !defined(HWY_COMPILE_ONLY_STATIC)  // sanitized: one set
    for (const char* set : {"SSE4", "SSSE3"})
        EXPECT_EQ(std::count(targets.begin(), targets.end(), set), 1) << set << " was not compiled";
#endif
    for (const std::string& target : targets) {
        use_kernel_target(target);
        EXPECT_EQ(kernel_target(), target);
        EXPECT_LE((stress_after_shear() - widest).norm(), 1e-9 * widest.norm()) << target;
    }
    hwy::GetChosenTarget().DeInit();
    EXPECT_EQ(kernel_target(), targets.front());
}

TEST(FastKernel, KnowsBothRollingForms) {
    Material total;
    total.rolling_form = RollingForm::total;
    ReferenceAssembly reference(dense(), total);
    FastAssembly fast(dense(), total), incremental(dense(), Material{});
    reference.step(shear(1), 1e-5, 300);
    fast.step(shear(1), 1e-5, 300);
    incremental.step(shear(1), 1e-5, 300);
    const Mat2 s = reference.stress();
    // The fast kernel counts the rotation of the step a contact is born in, the reference does not.
    EXPECT_LE((fast.stress() - s).norm(), 3e-4 * s.norm());
    EXPECT_GT((incremental.stress() - s).norm(), 10 * (fast.stress() - s).norm());
}

TEST(FastKernel, FollowsYadeThroughRelaxation) {
    const test::Table yade = test::read_table("path_b_dense.csv");
    FastAssembly fast(dense(), Material{});
    fast.step(Mat2::Zero(), 1e-5, 2000);
    EXPECT_LE((fast.stress() - yade.tensor(0, "s")).norm(), 1e-6 * yade.tensor(0, "s").norm());
}

TEST(FastKernel, ConservesMomentum) {
    // Internal forces cancel, and without damping nothing else acts on the fluctuation velocities.
    Material undamped;
    undamped.damping = 0;
    Packing p = dense();
    FastAssembly fast(p, undamped);
    fast.step(Mat2::Zero(), 1e-5, 500);
    const Packing q = fast.packing();
    double px = 0, py = 0, scale = 0;
    for (std::size_t g = 0; g < q.size(); ++g) {
        const double m = q.r[g] * q.r[g];
        px += m * q.vx[g], py += m * q.vy[g], scale += m * std::hypot(q.vx[g], q.vy[g]);
    }
    EXPECT_GT(scale, 0);
    EXPECT_LE(std::hypot(px, py), 1e-9 * scale);
}

TEST(FastKernel, RepeatsItselfBitForBit) {
    FastAssembly a(dense(), Material{}), b(dense(), Material{});
    a.step(shear(0.4), 1e-5, 3000);
    for (int part = 0; part < 3; ++part) b.step(shear(0.4), 1e-5, 1000);
    EXPECT_EQ(a.stress(), b.stress());
    EXPECT_EQ(a.packing().x, b.packing().x);
}

TEST(FastKernel, ShowsTheObservablesOfItsLastForces) {
    FastAssembly fast(dense(), Material{});
    fast.step(shear(0.4), 1e-5, 2000);
    EXPECT_LE((fast.observe().stress - fast.stress()).norm(), 1e-7 * fast.stress().norm());
}

// The reference step never reduces its cell: it goes through each reduction from the packing just before.
TEST(CellReduction, LeavesTheStressAloneAndTheCellCompact) {
    FastAssembly fast(dense(), Material{});
    double worst_angle = 0, worst_stress = 0;
    int reductions = 0;
    for (int part = 0; part < 400; ++part) {  // to a shear strain of 4
        const Mat2 before = fast.cell();
        const Packing start = fast.packing();
        fast.step(shear(50), 1e-6, 200);
        const Mat2 H = fast.cell();
        worst_angle = std::max(worst_angle, std::abs(H.col(0).dot(H.col(1))) /
                                                std::min(H.col(0).squaredNorm(), H.col(1).squaredNorm()));
        if ((H - before).norm() < 0.1 * H.norm()) continue;  // the shear of one part alone
        ReferenceAssembly reference(start, Material{});
        reference.step(shear(50), 1e-6, 200);
        worst_stress =
            std::max(worst_stress, (fast.stress() - reference.stress()).norm() / reference.stress().norm());
        ++reductions;
    }
    EXPECT_GE(reductions, 3);
    EXPECT_LT(worst_stress, 1e-3);  // history is laid on the normals of the first step; without it: 4e-3
    EXPECT_LT(worst_angle, 0.75);
    EXPECT_NEAR(fast.cell().determinant(), dense().H.determinant(), 1e-9);
}

TEST(CellReduction, IsContinuousInStress) {
    // The same packing in a sheared basis is the same packing.
    Packing p = dense();
    FastAssembly straight(p, Material{});
    p.H.col(1) += 2 * p.H.col(0);
    FastAssembly skewed(p, Material{});
    straight.step(shear(0.4), 1e-5, 100);
    skewed.step(shear(0.4), 1e-5, 100);
    EXPECT_LE((straight.stress() - skewed.stress()).norm(), 1e-9 * straight.stress().norm());
}

}  // namespace
}  // namespace sandgraph::dem
