#include "graph/screening/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/unit/graph/screening_bench.hpp"

namespace sandgraph::graph {
namespace {

// Answers well for a while, then not.
class Breaking : public support::ElementSurrogate {
  public:
    explicit Breaking(double scale) : scale_(scale) {}
    void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc, std::span<double> states,
                std::span<stress::SurrogateAnswer> answers) const override {
        ElementSurrogate::update(points, F_inc, states, answers);
        for (stress::SurrogateAnswer& a : answers)
            if (std::abs(a.stress.xx - a.stress.yy) > 4000) a.stress.xx *= scale_;
    }

  private:
    double scale_;
};

TEST(ScreeningLaw, StartsAtTheStressOfThePackings) {
    const auto bench = screening(2, setup_of(2, 1));
    EXPECT_EQ(bench.stress[1], tension_positive(support::public_packing().packing->stress));
}

TEST(ScreeningLaw, WithoutAGateTakesNoDemStep) {
    ScreeningSetup setup = setup_of(3, 0);
    setup.gate.active = false;
    auto bench = screening(3, setup);
    shear(bench, 500);
    EXPECT_EQ(bench.law.grain_use().dem_steps, 0);
    EXPECT_GT(bench.law.screening_log()->counters.surrogate_updates, 0);
    EXPECT_EQ(bench.law.modes().grain_points(), 0u);
}

TEST(ScreeningLaw, WithAThresholdOfZeroGivesTheBitsOfFullFidelity) {
    auto bench = screening(3, setup_of(3, 0));
    auto reference = full(3);
    shear(bench, 300), shear(reference, 300);
    EXPECT_EQ(bench.stress, reference.stress);
}

TEST(ScreeningLaw, PointsPastTheGateGoOverToTheirGrains) {
    auto bench = screening(3, setup_of(3, 2e-3));
    auto reference = full(3);
    shear(bench, 900), shear(reference, 900);  // point 1 to 3.6e-3, point 2 to 7.2e-3
    EXPECT_EQ(bench.law.modes()[0], PointMode::surrogate);
    ASSERT_EQ(bench.law.modes()[1], PointMode::grains);
    ASSERT_EQ(bench.law.modes()[2], PointMode::grains);
    EXPECT_LT(share(bench.stress[1], reference.stress[1]), 0.05);
    EXPECT_LT(share(bench.stress[2], reference.stress[2]), 0.05);
    ASSERT_EQ(bench.law.screening_log()->switches.size(), 2u);
    EXPECT_EQ(bench.law.screening_log()->switches[0].point, 2);
    EXPECT_EQ(bench.law.screening_log()->switches[0].reason, Reason::strain);
    EXPECT_GT(bench.law.screening_log()->counters.replay_steps, 0);
}

TEST(ScreeningLaw, TheStressDoesNotJumpWhereAPointIsHandedOver) {
    auto bench = screening(3, setup_of(3, 2e-3));
    double largest = 0;
    for (int k = 0; k < 900; ++k) {
        const Stress before = bench.stress[2];
        shear(bench, 1);
        largest = std::max(largest, norm(difference(bench.stress[2], before)));
    }
    ASSERT_GT(bench.law.screening_log()->switches.size(), 0u);
    const double jump = bench.law.screening_log()->switches[0].jump * 32e3;
    EXPECT_GT(jump, 0);
    EXPECT_LT(largest, 0.05 * jump + 0.03 * 32e3);
}

TEST(ScreeningLaw, AuditsChangeNoBitOfTheGround) {
    ScreeningSetup looked = setup_of(4, 3e-3), alone = looked;
    looked.audit.share = 1;
    auto a = screening(4, looked), b = screening(4, alone);
    shear(a, 700), shear(b, 700);
    EXPECT_EQ(a.stress, b.stress);
    a.law.audit_now(1);
    EXPECT_GT(a.law.screening_log()->audits.back().points, 0);
    EXPECT_GT(a.law.screening_log()->audits.back().mean, 0);
    EXPECT_GT(a.law.screening_log()->counters.audit_steps, 0);
    EXPECT_TRUE(std::isnan(b.law.observe(0).audited_error));
}

TEST(ScreeningLaw, TheAuditSeesTheErrorThatIsThere) {
    ScreeningSetup setup = setup_of(3, 1);
    setup.audit.share = 1;
    auto bench = screening(3, setup);
    auto reference = full(3);
    shear(bench, 800), shear(reference, 800);
    EXPECT_NEAR(bench.law.observe(2).audited_error, share(bench.stress[2], reference.stress[2]), 0.05);
}

class BrokenSurrogate : public testing::TestWithParam<double> {};

TEST_P(BrokenSurrogate, IsReplacedByTheGrains) {
    ScreeningSetup setup = setup_of(3, 1);
    setup.gate.active = false;
    setup.surrogate = std::make_shared<Breaking>(GetParam());
    auto bench = screening(3, setup);
    auto reference = full(3);
    shear(bench, 900), shear(reference, 900);
    ASSERT_EQ(bench.law.modes()[2], PointMode::grains);
    EXPECT_LT(share(bench.stress[2], reference.stress[2]), 0.05);
    EXPECT_EQ(bench.law.screening_log()->switches[0].reason, Reason::failed_answer);
    EXPECT_GE(bench.law.screening_log()->counters.failed_answers, 1);
    EXPECT_EQ(bench.law.counters().failures, 0);
}

INSTANTIATE_TEST_SUITE_P(Answers, BrokenSurrogate,
                         testing::Values(std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::infinity(), 30.0));

TEST(ScreeningLaw, NeighboursGoOverWithAPoint) {
    ScreeningSetup setup = setup_of(6, 2e-3);
    auto bench = screening(6, setup);
    for (int k = 0; k < 400; ++k) {
        for (auto& F : bench.F) F << 1 + 5e-7, 0, 0, 1 - 5e-7;
        bench.F[3] << 1 + 5e-6, 0, 0, 1 - 5e-6;
        stress::Batch batch = bench.batch();
        batch.around = {bench.x, bench.y, bench.volume, 1, 1e-3 * k};
        bench.law.update(batch);
    }
    for (std::size_t p = 0; p < 6; ++p) EXPECT_EQ(bench.law.modes().by_grains(p), p >= 2 && p <= 4) << p;
    for (const stress::Switch& s : bench.law.screening_log()->switches)
        EXPECT_EQ(s.reason, s.point == 3 ? Reason::strain : Reason::neighbour);
    EXPECT_NE(bench.law.screening_log()->counters.jump_work, 0);
}

}  // namespace
}  // namespace sandgraph::graph
