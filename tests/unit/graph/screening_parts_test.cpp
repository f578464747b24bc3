#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "graph/screening/acoustic.hpp"
#include "graph/screening/felt_jumps.hpp"
#include "tests/unit/graph/screening_stages.hpp"

// Parts of screening and of the packings' pool at the edges of what they promise.
namespace sandgraph::graph {
namespace {

Mat2 of(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }

TEST(Gate, TensionIsPassedWherePressureFallsToItsThreshold) {
    GateSettings set;
    GateView view;
    view.stress = {-2 * set.tension, -2 * set.tension, 0};
    EXPECT_DOUBLE_EQ(judge(view, set).level, 0.5);
    view.stress = {-set.tension, -set.tension, 0};
    EXPECT_DOUBLE_EQ(judge(view, set).level, 1);
}

// Soft in shear along the axes: det Q is C_xx G there and larger elsewhere.
TEST(AcousticTensor, IsLookedAtInAllDirections) {
    Eigen::Matrix3d C;
    C << 3, 1, 0, 1, 3, 0, 0, 0, 0.01;
    EXPECT_NEAR(least_acoustic_determinant(C), 0.03, 1e-12);
    C << 3, 2.98, 0, 2.98, 3, 0, 0, 0, 2;  // soft at 45 degrees
    EXPECT_NEAR(least_acoustic_determinant(C), 0.01 * (2.99 + 2), 1e-12);
}

TEST(AuditEstimate, AnErrorCountsAsOneAtMostAndALookAtHalfThePopulationKnowsMore) {
    const std::vector<double> errors{0.5, 3};
    EXPECT_DOUBLE_EQ(estimate(errors, 2).mean, 0.75);
    std::vector<double> even(100);
    for (std::size_t k = 0; k < even.size(); ++k) even[k] = 0.001 * double(k);
    const double all = estimate(even, 1'000'000'000).ci95, half = estimate(even, 200).ci95;
    EXPECT_NEAR(half / all, std::sqrt(0.5), 1e-6);
}

TEST(StressBlend, WhatIsLeftOfAJumpTurnsWithThePoint) {
    StressBlend blend(2, 4);
    blend.start(1, {-100, 300, 0});
    const double w = 1e-4;
    blend.turn(1, of(1, -w, w, 1)), blend.turn(0, of(1, -w, w, 1));
    EXPECT_NEAR(blend.rest(1).xy, -400 * w, 1e-9);
    EXPECT_EQ(blend.rest(0), Stress{});
}

// While it fades, as long after it, and no longer.
TEST(FeltJumps, AreWatchedForTwiceTheTimeThatAJumpTakesToFade) {
    FeltJumps felt(1, 2);
    std::vector<stress::Switch> switches(1);
    felt.watch(switches);
    const auto step = [&](double change) {
        const std::vector<Stress> now{{-1e4 - change, -1e4, 0}};
        felt.before(0, {-1e4, -1e4, 0});
        felt.after(now, 1e4, switches);
    };
    step(100), step(200);
    EXPECT_NEAR(switches[0].felt, 0.02, 3e-4);
    EXPECT_TRUE(std::isnan(switches[0].ordinary));
    step(50), step(30);
    EXPECT_NEAR(switches[0].felt, 0.02, 3e-4);
    EXPECT_NEAR(switches[0].ordinary, 0.005, 1e-4);
    step(5000);
    EXPECT_NEAR(switches[0].ordinary, 0.005, 1e-4);
}

// As a stress: 2 G times the error is the share of p.
TEST(ScreeningLaw, RecordsPathsAsFinelyAsTheirStressIsAsked) {
    ScreeningSetup setup = setup_of(1, 1);
    setup.hand_over.path_error = 0.04;
    ScreeningStages s(1, setup);
    const stress::PackingTraits traits = support::public_traits();
    EXPECT_NEAR(s.path(0).error(), 2 * 0.04 * traits.pressure / (2 * traits.shear), 1e-15);
}

TEST(Observe, PorosityOfAPointByGrainsHasWhatItsPackingHasNotSeen) {
    ScreeningSetup setup = setup_of(1, 1);
    setup.grains.visits = {.update_tolerance = 1e3, .update_change_max = 1e4};
    ScreeningStages s(1, setup);
    s.lead_to(PointMode::grains, 0);
    const double n = s.pool().porosity(0);
    s.predict(0, of(1.01, 0, 0, 1));
    EXPECT_NEAR(s.law.observe(0).porosity, 1 - (1 - n) / 1.01, 1e-12);
}

// Longest first, or one long drive at the end keeps all other processors waiting.
TEST(Route, PlansTheLongestDriveFirst) {
    ScreeningStages s(3);
    for (const std::int32_t p : {0, 1, 2}) {
        s.lead_to(PointMode::shadow, static_cast<std::size_t>(p));
        const double e = p == 1 ? 9e-4 : p == 2 ? 5e-4 : 2e-4;
        s.predict(p, of(1 + e, 0, 0, 1 - e));
    }
    EXPECT_EQ(s.planned(), (std::vector<std::int32_t>{1, 2, 0}));
}

TEST(RveLaw, BeginsWithTheLongestDrive) {
    auto bench = full(3);
    for (std::size_t p = 0; p < 3; ++p) {
        const double e = p == 1 ? 9e-4 : p == 2 ? 5e-4 : 2e-4;
        bench.F[p] = of(1 + e, 0, 0, 1 - e);
    }
    bench.law.update(bench.batch());
    const auto answers = bench.law.last_answers();
    ASSERT_EQ(answers.size(), 3u);
    EXPECT_GT(answers[0].report.dem_steps, answers[1].report.dem_steps);
    EXPECT_GT(answers[1].report.dem_steps, answers[2].report.dem_steps);
}

// There and back: two pieces at least.
TEST(RvePool, StepsOfAllPiecesAreCounted) {
    const auto packing = support::public_packing().packing;
    const auto pool = local_pool({packing}, dem::Material{}, support::table1_options());
    StrainPath path(1e-6);
    for (const double e : {1e-3, 0.0}) path.add(of(1 + e, 0, 0, 1 - e));
    const double alone = 1e-3 * std::sqrt(2.0) / pool->strain_per_step(0);
    const std::vector<RveJob> jobs{{.rve = 0, .increment = {}, .path = &path, .path_steps = 1'000'000}};
    std::vector<RveAnswer> answers(1);
    pool->drive(jobs, answers);
    EXPECT_GT(answers[0].report.dem_steps, 1.5 * alone);
    EXPECT_TRUE(answers[0].caught_up);
}

}  // namespace
}  // namespace sandgraph::graph
