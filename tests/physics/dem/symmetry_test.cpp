#include <algorithm>
#include <numeric>

#include "base/random.hpp"
#include "dem/rve.hpp"
#include "dem/stretch.hpp"
#include "public_packing.hpp"
#include "tests/support/table1_options.hpp"

namespace sandgraph::dem {
namespace {

using test::KernelKind, test::matrix, test::relative;

const Mat2 kPath = matrix(0.1, 0.4, 0, -0.1);  // [1/s]

Mat2 stress_after(KernelKind kind, const Packing& packing, const Material& material, const Mat2& L,
                  int steps) {
    const auto sample = test::assembly(kind, packing, material);
    sample->step(L, test::dt, steps);
    return sample->stress();
}

// Grains in another order; nothing else changes.
Packing reordered(const Packing& p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = 0; k < order.size(); ++k)
        std::swap(order[k], order[(k * k + 7 * k + 3) % order.size()]);
    Packing q = p;
    for (std::size_t g = 0; g < order.size(); ++g)
        q.x[g] = p.x[order[g]], q.y[g] = p.y[order[g]], q.r[g] = p.r[order[g]];
    return q;
}

// The whole packing turned by `angle` [rad].
Packing turned_packing(const Packing& p, double angle) {
    Packing q = p;
    q.H = rotation(angle) * p.H;
    for (std::size_t g = 0; g < p.size(); ++g) {
        const Vec2 x = rotation(angle) * Vec2(p.x[g], p.y[g]);
        q.x[g] = x.x(), q.y[g] = x.y();
    }
    return q;
}

class Symmetry : public testing::TestWithParam<KernelKind> {};

TEST_P(Symmetry, OrderOfGrainsIsNoPhysics) {
    const Packing p = test::public_packing("dense"), q = reordered(p);
    ASSERT_NE(p.x, q.x);
    EXPECT_LT(
        relative(stress_after(GetParam(), q, {}, kPath, 200), stress_after(GetParam(), p, {}, kPath, 200)),
        1e-10);
}

TEST_P(Symmetry, TurnedSandUnderTheTurnedPathGivesTheTurnedStress) {
    // Local damping acts on Cartesian components, the one direction-dependent part: without it to round-off.
    Material undamped;
    undamped.damping = 0;
    const Packing p = test::public_packing("dense");
    const double angle = 0.7;
    for (const auto& [material, tolerance] : {std::pair{undamped, 1e-9}, std::pair{Material{}, 2e-2}}) {
        const Mat2 fixed = stress_after(GetParam(), p, material, kPath, 200);
        const Mat2 other =
            stress_after(GetParam(), turned_packing(p, angle), material, turned(kPath, angle), 200);
        EXPECT_LT(relative(other, turned(fixed, angle)), tolerance);
    }
}

INSTANTIATE_TEST_SUITE_P(Kernel, Symmetry, testing::Values(KernelKind::reference, KernelKind::fast),
                         test::name_of);

// A path of steps F_k with a rigid turn laid on it: Q_(k+1) F_k Q_k^T.
struct TurningPath {
    Mat2 F;
    double turn, angle = 0;
    Mat2 next() {
        const Mat2 step = rotation(angle + turn) * F * rotation(angle).transpose();
        angle += turn;
        return step;
    }
};

TEST(Objectivity, ReferenceFeelsNothingOfASuperposedRotation) {
    const Packing p = test::resting("dense", {});
    ReferenceAssembly fixed(p, {}), turning(p, {});
    const Mat2 L = matrix(0.1, 0, 0, -0.1);
    TurningPath path{Mat2::Identity() + test::dt * L, 1e-5};
    for (int k = 0; k < 2000; ++k) {  // to 0.2 % and 1.1 degrees
        fixed.step(L, test::dt, 1);
        turning.step((path.next() - Mat2::Identity()) / test::dt, test::dt, 1);
    }
    EXPECT_LT(relative(turning.stress(), turned(fixed.stress(), path.angle)), 5e-3);
}

TEST(Objectivity, RveUnderASuperposedRotationFollowsTheTurnedReference) {
    const Packing p = test::resting("dense", {});
    ReferenceAssembly fixed(p, {});
    Rve rve(compact(p, {}, fixed.stress()));
    Workspace work;
    const Mat2 L = matrix(0.1, 0, 0, -0.1);
    TurningPath path{matrix(1 + 1e-4, 0, 0, 1 - 1e-4), 0.05};
    for (int k = 0; k < 20; ++k) {  // to 0.2 % and a whole radian
        fixed.step(L, test::dt, 100);
        ASSERT_EQ(rve.update(path.next(), {}, support::table1_options(), work).status, RveStatus::ok);
    }
    EXPECT_LT(relative(rve.stress(), turned(fixed.stress(), path.angle)), 1e-2);
}

}  // namespace
}  // namespace sandgraph::dem
