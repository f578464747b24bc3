#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "tests/unit/graph/screening_stages.hpp"

// The other stages of hand_over, each on a state set by hand.
namespace sandgraph::graph {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Mat2 of(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }

TEST(NoteFollowedStrain, TheSurrogatesDeformationGoesOnBehindTheGrains) {
    ScreeningStages s(2);
    s.lead_to(PointMode::grains, 1);
    s.F[1] = of(1.01, 0.02, 0, 0.98);
    const Mat2 step = of(1, 3e-3, -1e-3, 1.002), before = s.F[1];
    s.predict(1, step), s.followed(1, {});
    s.note_followed_strain();
    EXPECT_LT((s.F[1] - step * before).norm(), 1e-15) << "the new increment from the left";
    EXPECT_EQ(s.F[0], Mat2(Mat2::Identity()));
}

TEST(SettleGrains, TheAnswerOfAPackingIsThePointsStressInTension) {
    ScreeningStages s(2);
    s.lead_to(PointMode::grains, 1);
    s.predict(1, of(1 + 1e-5, 0, 0, 1 - 2e-5));
    RveAnswer answer;
    answer.stress = of(30e3, 4e3, 4e3, 40e3), answer.report.dem_steps = 17;
    const Stress kept = s.bench.stress[0];
    s.settle_grains(1, answer);
    EXPECT_EQ(s.bench.stress[1], (Stress{-30e3, -40e3, -4e3}));
    EXPECT_EQ(s.bench.stress[0], kept);
    EXPECT_EQ(s.counters().dem_steps, 17);
    EXPECT_EQ(s.counters().updates, 1);
    EXPECT_EQ(norm(s.change(1)), 0) << "predictions start anew";
}

TEST(SettleGrains, ARestOfTheJumpLiesOnTopOfTheAnswer) {
    ScreeningStages s(1);
    s.lead_to(PointMode::blending, 0);
    s.blend.start(0, {-200, 100, 50});
    RveAnswer answer;
    answer.stress = of(30e3, 0, 0, 40e3);
    s.settle_grains(0, answer);
    EXPECT_EQ(s.bench.stress[0], (Stress{-30200, -39900, 50}));
}

// rest : F_inc V, from strain and volume as the ground has them.
TEST(FadeJumps, CountsTheWorkOfTheJumpAndEndsTheBlend) {
    ScreeningSetup setup = setup_of(1, 1);
    setup.hand_over.blend_steps = 2;
    ScreeningStages s(2, setup);
    s.bench.volume = {0.25, 4};
    s.bench.F[0] = of(1 + 1e-3, 4e-4, 2e-4, 1 - 2e-3);
    s.bench.F[1] = of(1.5, 0, 0, 1.5);
    s.lead_to(PointMode::blending, 0);
    s.blend.start(0, {-8, 4, 2});
    s.fade_jumps();
    const double work = 0.25 * (-8 * 1e-3 + 4 * -2e-3 + 2 * 6e-4);
    EXPECT_NEAR(s.log().counters.jump_work, work, 1e-15);
    EXPECT_EQ(s.modes[0], PointMode::blending);
    s.fade_jumps();
    EXPECT_NEAR(s.log().counters.jump_work, 1.5 * work, 1e-15);
    EXPECT_EQ(s.modes[0], PointMode::grains);
}

TEST(SettleAnswers, TheSurrogatesAnswerIsThePointsStressAndItsStrainIsRecorded) {
    ScreeningStages s(1);
    const Mat2 step = of(1 + 2e-4, 1e-4, 0, 1 - 2e-4);
    s.predict(0, step);
    Stress near = s.bench.stress[0];
    near.xx += 100;
    s.settle_answer(0, {near, 0, 0});
    EXPECT_EQ(s.bench.stress[0], near);
    EXPECT_EQ(s.F[0], step);
    EXPECT_EQ(s.path(0).latest(), step);
    EXPECT_NE(s.verdict().reason, Reason::failed_answer);
}

TEST(SettleAnswers, OnceThePackingFollowsNoPathIsRecorded) {
    ScreeningStages s(1);
    s.lead_to(PointMode::shadow, 0);
    s.predict(0, of(1 + 2e-4, 0, 0, 1));
    s.settle_answer(0, {s.bench.stress[0], 0, 0});
    EXPECT_TRUE(s.path(0).done());
}

TEST(SettleAnswers, AnAbsurdAnswerLeavesThePredictionAndIsAFailure) {
    ScreeningStages s(1);
    s.predict(0, of(1 + 1e-5, 0, 0, 1));
    const Stress predicted = s.bench.stress[0];
    s.settle_answer(0, {{kNaN, -1, 0}, 0, 0});
    EXPECT_EQ(s.bench.stress[0], predicted);
    EXPECT_EQ(s.verdict().reason, Reason::failed_answer);
    EXPECT_EQ(s.verdict().level, 1);
}

// Half of p and twenty times the elastic change: 4 MPa of strain 1e-4 times 2 G and K.
TEST(Absurd, BeginsAtTwentyElasticChangesAndHalfThePressure) {
    ScreeningStages s(1);
    s.predict(0, of(1 + 1e-4, 0, 0, 1 - 1e-4));
    const Stress at = s.bench.stress[0];
    const double change = 2 * 1.4e7 * 1e-4 * std::sqrt(2.0), p = mean_stress(at);
    ASSERT_NEAR(norm(s.change(0)), change, 1e-6 * change);
    const auto off_by = [&](double d) {
        return s.absurd({{at.xx + d / std::sqrt(2.0), at.yy + d / std::sqrt(2.0), at.xy}, 0, 0}, 0, at);
    };
    EXPECT_FALSE(off_by(0.99 * (20 * change + 0.5 * p)));
    EXPECT_TRUE(off_by(1.01 * (20 * change + 0.5 * p)));
    EXPECT_TRUE(s.absurd({at, kNaN, 0}, 0, at));
    EXPECT_TRUE(s.absurd({at, 0, kNaN}, 0, at));
}

// d(sigma) : d(eps) of the answer over that of the elastic prediction, shear counted twice.
TEST(JudgeAnswer, SecondOrderWorkIsTheDoubleContractionOfChangeAndStrain) {
    ScreeningSetup setup = setup_of(1, 1e9);
    setup.gate.second_order_work = -0.1;
    ScreeningStages s(1, setup);
    s.judged({0}, {{}});
    s.predict(0, of(1 + 2e-4, 3e-4, 3e-4, 1 - 1e-4));
    const Stress predicted = s.bench.stress[0], off{-3e3, 1e3, -2.5e3};
    const Mat2 e = of(2e-4, 3e-4, 3e-4, -1e-4), d = of(off.xx, off.xy, off.xy, off.yy);
    const double K = 2.0e7, G = 1.4e7, volume = e.trace();
    const Mat2 elastic = K * volume * Mat2::Identity() + 2 * G * (e - 0.5 * volume * Mat2::Identity());
    const double work = 1 + (d.cwiseProduct(e)).sum() / (elastic.cwiseProduct(e)).sum();
    const Stress answered{predicted.xx + off.xx, predicted.yy + off.yy, predicted.xy + off.xy};
    const Verdict verdict = s.judge_answer({answered, 0, 0}, predicted);
    EXPECT_EQ(verdict.reason, Reason::second_order_work);
    EXPECT_NEAR(verdict.level, (1 - work) / 1.1, 2e-3 * verdict.level);
}

// Stiffness of a body whose shear modulus is a tenth of what it was; keeps the direction it was asked for.
struct SoftInShear : support::ElementSurrogate {
    stress::Tangent tangent(std::span<const double>, const Eigen::Vector3d& strain) const override {
        constexpr double K = 2.0e7, G = 1.4e6;
        direction = strain;
        return (stress::Tangent() << K + G, K - G, 0, K - G, K + G, 0, 0, 0, G).finished();
    }
    mutable Eigen::Vector3d direction;
};

// det Q over that of the elastic body, G (K + G); close to the stress ratio of failure only.
TEST(JudgeAnswer, TheAcousticTensorIsLookedAtNearTheStressRatioOfFailure) {
    ScreeningSetup setup = setup_of(1, 1e9);
    const auto soft = std::make_shared<SoftInShear>();
    setup.surrogate = soft, setup.gate.acoustic = 0, setup.gate.acoustic_from = 0.9;
    ScreeningStages s(1, setup);
    s.judged({0}, {{}});
    s.predict(0, of(1 + 1e-4, 3e-5, 3e-5, 1 - 1e-4));
    const double p = 32e3, limit = 0.9 * 0.5;  // of public_traits
    const auto judged = [&](double ratio) {
        const Stress at{-p * (1 - ratio), -p * (1 + ratio), 0};
        return s.judge_answer({at, 0, 0}, at);
    };
    EXPECT_NE(judged(0.98 * limit).reason, Reason::acoustic_tensor);
    const Verdict past = judged(1.02 * limit);
    EXPECT_EQ(past.reason, Reason::acoustic_tensor);
    EXPECT_NEAR(past.level, 1 - 1.4e6 * 21.4e6 / (14e6 * 34e6), 1e-9);
    EXPECT_NEAR(soft->direction[2] / soft->direction[0], 2 * 0.3, 1e-3) << "engineering shear strain";
}

TEST(SettleReplays, APackingThatHasCaughtUpIsAShadowAndItsPathIsForgotten) {
    ScreeningStages s(2);
    for (const std::size_t p : {0u, 1u}) {
        s.lead_to(PointMode::replay, p);
        s.path(p).add(of(1.001, 0, 0, 1)), s.path(p).add(of(1, 0, 0, 1.001));
        ASSERT_GT(s.path(p).knots(), 0u);
    }
    s.settle_replays(0, false), s.settle_replays(1, true);
    EXPECT_EQ(s.modes[0], PointMode::replay);
    EXPECT_GT(s.path(0).knots(), 0u);
    EXPECT_EQ(s.modes[1], PointMode::shadow);
    EXPECT_EQ(s.path(1).knots(), 0u);
}

TEST(ReplaceFailed, DrivesThePackingToTheEndOfItsPathAtOnce) {
    ScreeningStages s(3);
    const Mat2 end = of(1 + 2e-3, 1e-3, 0, 1 - 2e-3);
    s.path(1).add(end), s.path(2).add(end);
    s.judged({1, 2}, {{1, Reason::failed_answer}, {1.5, Reason::strain}});
    s.replace_failed();
    EXPECT_EQ(s.modes[1], PointMode::shadow);
    EXPECT_NEAR(s.pool().rve(1).volume_ratio(), end.determinant(), 1e-12);
    EXPECT_GT(s.log().counters.replay_steps, 100);
    EXPECT_EQ(s.log().counters.failed_answers, 1);
    EXPECT_EQ(s.modes[2], PointMode::surrogate) << "its answer can be used";
    EXPECT_EQ(s.pool().rve(2).volume_ratio(), 1);
    EXPECT_FALSE(s.path(2).done());
    EXPECT_EQ(s.pool().owning(), 1u);
}

TEST(SwitchReady, HandsOverAShadowWithAReasonAndItsJump) {
    ScreeningStages s(3);
    for (const std::size_t p : {0u, 1u}) s.lead_to(PointMode::shadow, p);
    s.modes.set_reason(1, Reason::tension), s.modes.set_reason(2, Reason::strain);
    const Stress by_grains = tension_positive(s.pool().stress(1)), jump{-600, 0, 400};
    s.bench.stress[1] = {by_grains.xx + jump.xx, by_grains.yy + jump.yy, by_grains.xy + jump.xy};
    s.judged({0, 1, 2}, std::vector<Verdict>(3));
    s.switch_ready();
    EXPECT_EQ(s.modes[0], PointMode::shadow) << "nothing asks for its grains";
    EXPECT_EQ(s.modes[2], PointMode::surrogate) << "its packing is not ready";
    ASSERT_EQ(s.modes[1], PointMode::blending);
    EXPECT_NEAR(s.blend.rest(1).xx, jump.xx, 1e-9);
    EXPECT_NEAR(s.blend.rest(1).xy, jump.xy, 1e-9);
    ASSERT_EQ(s.log().switches.size(), 1u);
    const stress::Switch& one = s.log().switches[0];
    EXPECT_EQ(one.point, 1);
    EXPECT_EQ(one.reason, Reason::tension);
    EXPECT_EQ(one.d_over_B, 0.25);
    EXPECT_NEAR(one.jump, norm(jump) / mean_stress(by_grains), 1e-9);
}

struct HandBack : testing::Test {
    static ScreeningSetup with_flow() {
        ScreeningSetup setup = setup_of(1, 1);
        setup.gate.flow = 0.1, setup.gate.spread = 0.4, setup.audit.share = 1;
        return setup;
    }
    HandBack() : s(1, with_flow()) {
        s.lead_to(PointMode::grains, 0);
        strain(0.101);
    }
    // ln l1 - ln l2 of the point.
    void strain(double e) { s.F[0] = of(std::exp(0.5 * e), 0, 0, std::exp(-0.5 * e)); }
    PointMode after(const stress::SurrogateAnswer& answer) {
        s.followed(0, answer);
        s.hand_back();
        return s.modes[0];
    }
    ScreeningStages s;
    stress::SurrogateAnswer fine{{-31e3, -33e3, 500}, 0, 0};
};

TEST_F(HandBack, PastTheStrainOfCriticalStateTheSurrogateAnswersAgainWithTheJumpOnTop) {
    const Stress before = s.bench.stress[0];
    EXPECT_EQ(after(fine), PointMode::critical_state);
    EXPECT_EQ(s.blend.rest(0), difference(before, fine.stress));
    EXPECT_TRUE(s.blend.fading(0));
    const stress::Switch& one = s.log().switches.at(0);
    EXPECT_EQ(one.reason, Reason::critical_state);
    EXPECT_NEAR(one.jump, norm(difference(before, fine.stress)) / mean_stress(before), 1e-12);
}

TEST_F(HandBack, ItsAuditGoesOnWithTheGrainsThatHaveAnswered) {
    const std::vector<RveJob> jobs{{.rve = 0, .increment = of(1 + 1e-4, 0, 0, 1 - 2e-4)}};
    std::vector<RveAnswer> answers(1);
    s.pool().drive(jobs, answers);
    ASSERT_NE(s.pool().stress(0), s.pool().stress(1));
    after(fine);
    EXPECT_EQ(s.pool().stress(0), s.pool().stress(1));
    EXPECT_EQ(s.law.observe(0).audited_error, 0);
}

TEST_F(HandBack, NotBeforeThatStrain) {
    strain(0.099);
    EXPECT_EQ(after(fine), PointMode::grains);
    EXPECT_TRUE(s.log().switches.empty());
    strain(-0.101);
    EXPECT_EQ(after(fine), PointMode::critical_state) << "whatever way it is sheared";
}

TEST_F(HandBack, NotToMembersThatPartByMoreThanThreeTimesTheGatesThreshold) {
    fine.spread = 1.21;
    EXPECT_EQ(after(fine), PointMode::grains);
    fine.spread = 1.19;
    EXPECT_EQ(after(fine), PointMode::critical_state);
}

TEST_F(HandBack, NotToAnAnswerThatIsNoNumber) {
    fine.stress.xy = kNaN;
    EXPECT_EQ(after(fine), PointMode::grains);
}

TEST_F(HandBack, NotWhereTheSurrogateHasFailed) {
    s.modes.set_reason(0, Reason::failed_answer);
    EXPECT_EQ(after(fine), PointMode::grains);
}

TEST_F(HandBack, NotWhileGrainsFloat) {
    const std::vector<RveJob> jobs{{.rve = 0, .increment = of(1.2, 0, 0, 1.2)}};
    std::vector<RveAnswer> answers(1);
    s.pool().drive(jobs, answers);
    ASSERT_TRUE(s.pool().floating(0));
    EXPECT_EQ(after(fine), PointMode::grains);
}

TEST(CloseStep, CountsStepsAndPointsByGrainsAndAuditsWhenDue) {
    ScreeningSetup setup = setup_of(1, 1);
    setup.audit = {.share = 1, .seed = 1, .every = 0.01};
    ScreeningStages s(3, setup);
    s.lead_to(PointMode::grains, 0), s.lead_to(PointMode::blending, 1), s.lead_to(PointMode::shadow, 2);
    s.close_step(0), s.close_step(0.0099), s.close_step(0.0101);
    EXPECT_EQ(s.log().counters.steps, 3);
    EXPECT_EQ(s.log().counters.dem_points, 6);
    ASSERT_EQ(s.log().audits.size(), 2u);
    EXPECT_EQ(s.log().audits[1].d_over_B, 0.0101);
    EXPECT_EQ(s.log().audits[1].population, 1);
}

}  // namespace
}  // namespace sandgraph::graph
