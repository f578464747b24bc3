#include <gtest/gtest.h>

#include <set>

#include "graph/screening/blend.hpp"
#include "graph/screening/modes.hpp"
#include "graph/stress_arithmetic.hpp"
#include "tests/unit/graph/screening_bench.hpp"

namespace sandgraph::graph {
namespace {

constexpr std::array kEvents = {ModeEvent::near_gate, ModeEvent::caught_up, ModeEvent::handed_over,
                                ModeEvent::faded,     ModeEvent::flows,     ModeEvent::answer_failed};

// Drives a point by the table alone.
Modes at(PointMode wanted) {
    Modes modes(1, PointMode::surrogate);
    for (const ModeEvent event : {ModeEvent::near_gate, ModeEvent::caught_up, ModeEvent::handed_over,
                                  ModeEvent::faded, ModeEvent::flows})
        if (modes[0] != wanted) modes.apply(0, event);
    return modes;
}

TEST(Modes, AnEventLeadsWhereTheTableSaysAndNowhereElse) {
    for (std::size_t m = 0; m < mode_count; ++m)
        for (const ModeEvent event : kEvents) {
            Modes modes = at(static_cast<PointMode>(m));
            const auto row = std::ranges::find_if(transitions, [&](const Transition& t) {
                return t.from == static_cast<PointMode>(m) && t.on == event;
            });
            EXPECT_EQ(modes.allows(0, event), row != transitions.end());
            if (row == transitions.end()) {
                EXPECT_THROW(modes.apply(0, event), std::logic_error);
            } else {
                modes.apply(0, event);
                EXPECT_EQ(modes[0], row->to);
            }
        }
}

TEST(Modes, EveryModeCanBeReachedAndThePairsAreUnique) {
    std::set<std::pair<int, int>> pairs;
    std::set<PointMode> reached{PointMode::surrogate};
    for (const Transition& t : transitions) {
        EXPECT_TRUE(pairs.emplace(static_cast<int>(t.from), static_cast<int>(t.on)).second);
        reached.insert(t.to);
    }
    EXPECT_EQ(reached.size(), mode_count);
}

TEST(Modes, CountThePointsThatGrainsAnswerFor) {
    Modes modes(3, PointMode::surrogate);
    for (const ModeEvent event : {ModeEvent::near_gate, ModeEvent::caught_up}) modes.apply(1, event);
    EXPECT_EQ(modes.grain_points(), 0u);
    modes.apply(1, ModeEvent::handed_over);
    EXPECT_EQ(modes.grain_points(), 1u);
    modes.apply(1, ModeEvent::faded);
    EXPECT_EQ(modes.grain_points(), 1u);
    modes.apply(1, ModeEvent::flows);
    EXPECT_EQ(modes.grain_points(), 0u);
    EXPECT_EQ(Modes(3, PointMode::grains).grain_points(), 3u);
}

TEST(StressBlend, FadesInEqualSteps) {
    StressBlend blend(2, 4);
    std::vector<Mat2> F(2, Mat2::Identity());
    std::vector<Stress> stress(2, Stress{-100, -200, 30});
    double work = 0;
    blend.start(1, {-8, 4, 2});
    for (int step = 1; step <= 4; ++step) {
        blend.fade(F, {}, stress, work);
        EXPECT_NEAR(stress[1].xx, -100 + 2 * step, 1e-12);
        EXPECT_NEAR(stress[1].yy, -200 - 1 * step, 1e-12);
        EXPECT_NEAR(stress[1].xy, 30 - 0.5 * step, 1e-12);
        EXPECT_EQ(blend.fading(1), step < 4);
        EXPECT_EQ(blend.ended().size(), step < 4 ? 0u : 1u);
    }
    EXPECT_EQ(stress[0], (Stress{-100, -200, 30}));
    blend.fade(F, {}, stress, work);
    EXPECT_NEAR(stress[1].xx, -92, 1e-12);
}

// rest : d(eps) V, with the whole rest as it stands before the step.
TEST(StressBlend, CountsTheWorkOfTheJump) {
    StressBlend blend(1, 2);
    std::vector<Mat2> F(1);
    F[0] << 1 + 1e-3, 4e-4, 2e-4, 1 - 2e-3;
    std::vector<Stress> stress(1);
    const std::vector<double> volume{0.5};
    double work = 0;
    blend.start(0, {-8, 4, 2});
    blend.fade(F, volume, stress, work);
    const double whole = 0.5 * (-8 * 1e-3 + 4 * -2e-3 + 2 * 6e-4);
    EXPECT_NEAR(work, whole, 1e-15);
    blend.fade(F, volume, stress, work);
    EXPECT_NEAR(work, 1.5 * whole, 1e-15);
}

TEST(StressBlend, WhatWouldPullIsCutOff) {
    EXPECT_EQ(tension_cut_off({-10, -10, 0}, {-5, 5, 0}), (Stress{-5, 5, 0}));
    EXPECT_EQ(tension_cut_off({-10, -10, 0}, {16, 0, 0}), (Stress{8, 0, 0}));
    EXPECT_EQ(tension_cut_off({0, 0, 0}, {16, 0, 0}), (Stress{0, 0, 0}));
}

TEST(AuditSample, MeasuresItsPointsAndThoseThatCount) {
    AuditSample sample(4, {.share = 1});
    for (std::int32_t k = 0; k < 4; ++k) sample.measure(k, {-2000.0 - 200 * k, -2000, 0}, {-2000, -2000, 0});
    EXPECT_DOUBLE_EQ(sample.error(1), 0.1);
    const AuditRow row = sample.now(2, [](std::int32_t p) { return p >= 2; });
    EXPECT_EQ(row.points, 2);
    EXPECT_DOUBLE_EQ(row.mean, 0.25);
    sample.forget(3);
    EXPECT_DOUBLE_EQ(sample.now(2, [](std::int32_t p) { return p >= 2; }).mean, 0.1);
}

// Small pressures do not blow an error up.
TEST(AuditSample, ErrorsAreSharesOfAKilopascalAtLeast) {
    AuditSample sample(1, {.share = 1});
    sample.measure(0, {-110, -100, 0}, {-100, -100, 0});
    EXPECT_DOUBLE_EQ(sample.error(0), 0.01);
}

TEST(AuditSample, IsDueAtEvenDisplacements) {
    AuditSample sample(1, {.share = 1, .every = 0.01});
    EXPECT_TRUE(sample.due(0));
    sample.schedule_after(0);
    EXPECT_FALSE(sample.due(0.0099));
    EXPECT_TRUE(sample.due(0.01));
    sample.schedule_after(0.035);
    EXPECT_FALSE(sample.due(0.0399));
    EXPECT_TRUE(sample.due(0.0401));
}

std::unique_ptr<RvePool> two_packings() {
    const auto packing = support::public_packing().packing;
    return local_pool({packing, packing}, dem::Material{}, support::table1_options());
}

TEST(RvePool, GivesTheAnswersOfThePackingsItOwns) {
    const auto pool = two_packings();
    const Mat2 F_inc = (Mat2() << 1 + 2e-4, 1e-4, 0, 1 - 2e-4).finished();
    dem::Rve alone(support::public_packing().packing);
    dem::Workspace work;
    const dem::RveReport report = alone.update(F_inc, {}, support::table1_options(), work);
    const std::vector<RveJob> jobs{{.rve = 1, .increment = F_inc, .observed = true}};
    std::vector<RveAnswer> answers(1);
    pool->drive(jobs, answers);
    EXPECT_EQ(answers[0].report.dem_steps, report.dem_steps);
    EXPECT_EQ(answers[0].stress, alone.stress());
    EXPECT_EQ(pool->stress(1), alone.stress());
    EXPECT_EQ(answers[0].volume_ratio, alone.volume_ratio());
    ASSERT_TRUE(answers[0].seen.has_value());
    EXPECT_EQ(pool->owning(), 1u);
    pool->copy(1, 0);
    EXPECT_EQ(pool->stress(0), alone.stress());
}

TEST(RvePool, CatchesUpAlongAPathInPiecesAndThenTakesTheIncrement) {
    const auto pool = two_packings();
    StrainPath path(1e-6);
    const Mat2 end = (Mat2() << 1 + 1e-3, 0, 0, 1 - 1e-3).finished(), more = Mat2::Identity() * (1 - 1e-5);
    path.add(end);
    RveJob job{.rve = 0, .increment = more, .path = &path, .path_steps = 20};
    std::vector<RveAnswer> answers(1);
    int calls = 0, steps = 0;
    do {
        pool->drive(std::span(&job, 1), answers);
        steps += answers[0].report.dem_steps;
    } while (!answers[0].caught_up && ++calls < 1000);
    EXPECT_GT(calls, 3);
    EXPECT_GT(steps, 20 * calls);
    EXPECT_TRUE(path.done());
    EXPECT_NEAR(answers[0].volume_ratio, (more * end).determinant(), 1e-12);
}

}  // namespace
}  // namespace sandgraph::graph
