#include "public_packing.hpp"

namespace sandgraph::dem {
namespace {

using test::KernelKind, test::matrix;

// Newton's law runs both ways as long as nothing dissipates. The leapfrog step does, too, when it is turned
// round between kick and drift: positions of the last forces, velocities after them with the sign changed,
// and the contact history one step on, since each evaluation first undoes the increment of the motion that
// led to it.
Packing turned_round(Assembly& sample) {
    sample.step(Mat2::Zero(), test::dt, 1);
    Packing p = sample.packing();
    sample.step(Mat2::Zero(), test::dt, 1);
    p.contacts = sample.packing().contacts;
    for (std::size_t g = 0; g < p.size(); ++g) {
        p.x[g] -= test::dt * p.vx[g], p.y[g] -= test::dt * p.vy[g];
        p.vx[g] = -p.vx[g], p.vy[g] = -p.vy[g], p.spin[g] = -p.spin[g];
    }
    return p;
}

struct Reversal {
    double excursion = 0, left = 0;  // |stress - initial|, at the far end and back again [Pa]
};

Reversal there_and_back(KernelKind kind, const Material& material, const Mat2& L, int steps) {
    const Packing start = test::resting("dense", material);
    const auto there = test::assembly(kind, start, material);
    there->step(L, test::dt, 1);
    const Mat2 initial = there->stress();
    there->step(L, test::dt, steps - 1);
    Reversal result;
    result.excursion = (there->stress() - initial).norm();
    const auto back = test::assembly(kind, turned_round(*there), material);
    back->step(-L, test::dt, steps);
    back->step(Mat2::Zero(), test::dt, 1);
    result.left = (back->stress() - initial).norm();
    return result;
}

Material undamped() {
    Material material;
    material.damping = 0;
    return material;
}

class TimeReversal : public testing::TestWithParam<KernelKind> {};

TEST_P(TimeReversal, StickingGrainsRunBackTheWayTheyCame) {
    Material sticking = undamped();
    sticking.friction_angle = 1.57, sticking.rolling_limit = 1e6;
    for (const Mat2& L : {matrix(0, 0.01, 0.01, 0), matrix(-0.01, 0, 0, -0.01), matrix(0.01, 0, 0, -0.01)}) {
        const Reversal r = there_and_back(GetParam(), sticking, L, 500);
        EXPECT_GT(r.excursion, 100);
        EXPECT_LT(r.left, 1e-3 * r.excursion);
        RecordProperty("left", std::to_string(r.left / r.excursion));
    }
}

TEST_P(TimeReversal, SandRunsBackInItsElasticRange) {
    for (const double sign : {1.0, -1.0}) {
        const Reversal r = there_and_back(GetParam(), undamped(), sign * matrix(0, 1e-3, 1e-3, 0), 500);
        EXPECT_GT(r.excursion, 10);
        EXPECT_LT(r.left, 0.02 * r.excursion);
        RecordProperty("left", std::to_string(r.left / r.excursion));
    }
}

TEST_P(TimeReversal, YieldingSandDoesNotRunBack) {
    const Reversal r = there_and_back(GetParam(), undamped(), matrix(0.2, 0, 0, -0.2), 2000);
    EXPECT_GT(r.left, 0.1 * r.excursion);
}

INSTANTIATE_TEST_SUITE_P(Kernel, TimeReversal, testing::Values(KernelKind::reference, KernelKind::fast),
                         test::name_of);

}  // namespace
}  // namespace sandgraph::dem
