#include "graph/rve_law.hpp"

#include <gtest/gtest.h>

#include "tests/support/public_packing.hpp"
#include "tests/support/table1_options.hpp"

namespace sandgraph::graph {
namespace {

using support::public_packing;

// A few points on one packing, driven by hand.
struct Bench {
    explicit Bench(std::size_t points, double tolerance = 0.005)
        : law({{},
               support::table1_options(),
               {public_packing()},
               std::vector<std::int32_t>(points, 0),
               tolerance}),
          ids(points),
          F(points, Mat2::Identity()),
          stress(points) {
        for (std::size_t p = 0; p < points; ++p) ids[p] = static_cast<std::int32_t>(p);
        law.initialise(batch());
    }
    stress::Batch batch() { return {ids, F, stress, 1e-4}; }
    void step(const Mat2& every) {
        std::fill(F.begin(), F.end(), every);
        law.update(batch());
    }
    RveLaw law;
    std::vector<std::int32_t> ids;
    std::vector<Mat2> F;
    std::vector<Stress> stress;
};

Mat2 increment(double xx, double xy, double yy) { return (Mat2() << 1 + xx, xy, xy, 1 + yy).finished(); }
double distance(const Stress& a, const Stress& b) {
    return std::sqrt(std::pow(a.xx - b.xx, 2) + std::pow(a.yy - b.yy, 2) + 2 * std::pow(a.xy - b.xy, 2));
}

TEST(RveLaw, StartsAtTheStressOfThePacking) {
    Bench bench(3);
    EXPECT_EQ(bench.stress[2], tension_positive(public_packing().packing->stress));
}

TEST(RveLaw, QuietPointsOwnNoPackingAndTakeNoDemStep) {
    Bench bench(4);
    for (int k = 0; k < 100; ++k) bench.step(increment(k % 2 ? 1e-7 : -1e-7, 0, 0));
    EXPECT_EQ(bench.law.owning(), 0u);
    EXPECT_EQ(bench.law.counters().dem_steps, 0);
}

TEST(RveLaw, PredictionStaysCloseToUpdatingAtEveryStep) {
    Bench skipping(1), always(1, 0);
    for (int k = 0; k < 400; ++k) {
        skipping.step(increment(2e-6, 0, -2e-6));
        always.step(increment(2e-6, 0, -2e-6));
    }
    const double p = mean_stress(always.stress[0]);
    EXPECT_LT(distance(skipping.stress[0], always.stress[0]), 0.03 * p);
    EXPECT_LT(skipping.law.counters().updates, always.law.counters().updates / 4);
}

TEST(RveLaw, AllowanceKeepsTheErrorNearTheTolerance) {
    Bench bench(1, 0.005);
    for (int k = 0; k < 2000; ++k) bench.step(increment(1e-6, 0, -1e-6));
    const RveCounters& c = bench.law.counters();
    EXPECT_GT(c.predicted, 10);
    EXPECT_LT(c.prediction_error_sum / static_cast<double>(c.predicted), 0.01);
}

TEST(RveLaw, SplittingTheBatchChangesNoBit) {
    Bench whole(5), split(5);
    for (int k = 0; k < 50; ++k) {
        for (std::size_t p = 0; p < 5; ++p)
            whole.F[p] = split.F[p] = increment(1e-6 * static_cast<double>(p), 3e-6, -2e-6);
        whole.law.update(whole.batch());
        const std::span<const std::int32_t> ids(split.ids);
        split.law.update({ids.subspan(3), split.F, split.stress, 1e-4});
        split.law.update({ids.first(3), split.F, split.stress, 1e-4});
    }
    EXPECT_EQ(whole.stress, split.stress);
}

TEST(RveLaw, ABadIncrementIsCountedAndLeavesTheRestAlone) {
    Bench bench(2), clean(2);
    bench.F[0] = increment(-3, 0, 0);
    bench.F[1] = clean.F[1] = increment(0, 1e-4, 0);
    bench.law.update(bench.batch());
    clean.law.update(clean.batch());
    EXPECT_EQ(bench.law.counters().failures, 1);
    EXPECT_EQ(bench.stress[1], clean.stress[1]);
    EXPECT_NE(bench.stress[1], bench.stress[0]);
    EXPECT_EQ(bench.stress[0], tension_positive(public_packing().packing->stress));
}

// One step of a path on which the points part; point 1 turns and reverses.
void shear_unevenly(Bench& bench, int step) {
    for (std::size_t p = 0; p < bench.F.size(); ++p)
        bench.F[p] = increment(2e-6 * static_cast<double>(p), 3e-6, -1e-6);
    bench.F[1](0, 1) += step % 3 ? 4e-6 : -6e-6;
    bench.law.update(bench.batch());
}

TEST(RveLaw, WatchedUpdatesReplayToTheSameStress) {
    Bench bench(3);
    bench.law.watch(std::vector<std::int32_t>{1});
    dem::Rve twin(public_packing().packing);
    dem::Workspace work;
    int updates = 0;
    for (int step = 0; step < 300; ++step) {
        shear_unevenly(bench, step);
        for (const dem::RveUpdate& u : support::watched(bench.law)) {
            ++updates;
            EXPECT_EQ(u.point, 1);
            EXPECT_EQ(twin.update(u.F_inc, {}, support::table1_options(), work).dem_steps,
                      u.report.dem_steps);
            EXPECT_EQ(twin.stress(), u.stress);
            EXPECT_EQ(twin.volume_ratio(), u.volume_ratio);
            EXPECT_NEAR(u.seen.fabric.trace(), 1, 1e-12);
        }
    }
    EXPECT_GT(updates, 5);
}

TEST(RveLaw, WatchingChangesNoBit) {
    Bench watched(3), alone(3);
    watched.law.watch(std::vector<std::int32_t>{0, 2});
    std::size_t updates = 0;
    for (int step = 0; step < 100; ++step) {
        shear_unevenly(watched, step), shear_unevenly(alone, step);
        updates += support::watched(watched.law).size();
    }
    EXPECT_GT(updates, 2u);
    EXPECT_EQ(watched.stress, alone.stress);
    EXPECT_TRUE(support::watched(alone.law).empty());
}

}  // namespace
}  // namespace sandgraph::graph
