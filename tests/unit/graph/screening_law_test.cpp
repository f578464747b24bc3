#include "graph/screening_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graph/stress_arithmetic.hpp"
#include "tests/support/element_surrogate.hpp"
#include "tests/support/public_packing.hpp"

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

ScreeningSetup setup_of(std::size_t points, double strain) {
    ScreeningSetup s;
    s.grains = {{}, {}, {support::public_packing()}, std::vector<std::int32_t>(points, 0)};
    s.surrogate = std::make_shared<support::ElementSurrogate>();
    s.traits = {support::public_traits()};
    s.gate.strain = strain;
    s.gate.stress_ratio = s.gate.spread = s.gate.distance = 1e9;
    s.gate.work = s.gate.acoustic = -1e9;
    s.audit.share = 0;
    s.hand_over.blend_steps = 40;
    return s;
}

template <class AnyLaw>
struct Bench {
    Bench(std::size_t points, AnyLaw made) : law(std::move(made)) {
        for (std::size_t p = 0; p < points; ++p) {
            ids.push_back(static_cast<std::int32_t>(p));
            x.push_back(static_cast<double>(p)), y.push_back(0), volume.push_back(1);
        }
        F.assign(points, Mat2::Identity()), stress.resize(points);
        law.initialise(batch());
    }
    stress::Batch batch() { return {ids, F, stress, 1e-4}; }
    AnyLaw law;
    std::vector<std::int32_t> ids;
    std::vector<Mat2> F;
    std::vector<Stress> stress;
    std::vector<double> x, y, volume;
};

// Points strain the more the higher their id; the last one turns as well.
template <class AnyLaw>
void shear(Bench<AnyLaw>& b, int steps) {
    for (std::size_t p = 0; p < b.F.size(); ++p) {
        const double e = 2e-6 * static_cast<double>(p);
        b.F[p] << 1 + e, 0, 0, 1 - e;
    }
    b.F.back()(0, 1) = 1e-6, b.F.back()(1, 0) = -1e-6;
    for (int k = 0; k < steps; ++k) b.law.update(b.batch());
}

Bench<ScreeningLaw> screening(std::size_t points, const ScreeningSetup& setup) {
    return {points, ScreeningLaw(setup)};
}
Bench<RveLaw> full(std::size_t points) { return {points, RveLaw(setup_of(points, 0).grains)}; }

double share(const Stress& a, const Stress& b) { return norm(difference(a, b)) / mean_stress(b); }

TEST(ScreeningLaw, StartsAtTheStressOfThePackings) {
    const auto bench = screening(2, setup_of(2, 1));
    EXPECT_EQ(bench.stress[1], tension_positive(support::public_packing().packing->stress));
}

TEST(ScreeningLaw, WithoutAGateTakesNoDemStep) {
    ScreeningSetup setup = setup_of(3, 0);
    setup.gate.active = false;
    auto bench = screening(3, setup);
    shear(bench, 500);
    EXPECT_EQ(bench.law.dem_steps(), 0);
    EXPECT_GT(bench.law.screening().surrogate_updates, 0);
    EXPECT_EQ(bench.law.grain_points(), 0u);
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
    EXPECT_EQ(bench.law.mode(0), PointMode::surrogate);
    ASSERT_EQ(bench.law.mode(1), PointMode::grains);
    ASSERT_EQ(bench.law.mode(2), PointMode::grains);
    EXPECT_LT(share(bench.stress[1], reference.stress[1]), 0.05);
    EXPECT_LT(share(bench.stress[2], reference.stress[2]), 0.05);
    ASSERT_EQ(bench.law.switches().size(), 2u);
    EXPECT_EQ(bench.law.switches()[0].point, 2);
    EXPECT_EQ(bench.law.switches()[0].reason, Reason::strain);
    EXPECT_GT(bench.law.screening().replay_steps, 0);
}

TEST(ScreeningLaw, TheStressDoesNotJumpWhereAPointIsHandedOver) {
    auto bench = screening(3, setup_of(3, 2e-3));
    double largest = 0;
    for (int k = 0; k < 900; ++k) {
        const Stress before = bench.stress[2];
        shear(bench, 1);
        largest = std::max(largest, norm(difference(bench.stress[2], before)));
    }
    ASSERT_GT(bench.law.switches().size(), 0u);
    const double jump = bench.law.switches()[0].jump * 32e3;
    EXPECT_GT(jump, 0);
    EXPECT_LT(largest, 0.05 * jump + 0.03 * 32e3);
}

const Switch& last_switch(const ScreeningLaw& law, std::int32_t point) {
    const auto of_point = [&](const Switch& s) { return s.point == point; };
    return *std::find_if(law.switches().rbegin(), law.switches().rend(), of_point);
}

// At 7.2e-3 of strain it has been by grains from 2e-3 to 4e-3; 40 steps later nothing is left of the jump.
TEST(ScreeningLaw, APointThatFlowsGoesBackToTheSurrogateThatHasFollowedIt) {
    ScreeningSetup setup = setup_of(3, 2e-3), alone = setup;
    setup.gate.flow = 4e-3, alone.gate.active = false;
    auto bench = screening(3, setup), surrogate = screening(3, alone);
    shear(bench, 800), shear(surrogate, 800);
    ASSERT_EQ(bench.law.mode(2), PointMode::flow);
    EXPECT_EQ(last_switch(bench.law, 2).reason, Reason::flow);
    EXPECT_FALSE(bench.law.by_grains(2));
    const std::int64_t paid = bench.law.dem_steps();
    bench.F[1] = Mat2::Identity(), shear(surrogate, 100);
    for (int k = 0; k < 100; ++k) bench.law.update(bench.batch());
    EXPECT_EQ(bench.law.dem_steps(), paid);
    EXPECT_LT(share(bench.stress[2], surrogate.stress[2]), 0.01);
}

TEST(ScreeningLaw, TheStressDoesNotJumpWhereAPointGoesBack) {
    ScreeningSetup setup = setup_of(3, 2e-3);
    setup.gate.flow = 4e-3;
    auto bench = screening(3, setup);
    double largest = 0;
    for (int k = 0; k < 900; ++k) {
        const Stress before = bench.stress[2];
        shear(bench, 1);
        largest = std::max(largest, norm(difference(bench.stress[2], before)));
    }
    ASSERT_EQ(last_switch(bench.law, 2).reason, Reason::flow);
    double jumps = 0;
    for (const Switch& s : bench.law.switches()) jumps += s.jump * 32e3;
    EXPECT_LT(largest, 0.05 * jumps + 0.03 * 32e3);
}

// Its second packing takes over what its grains have been through.
TEST(ScreeningLaw, TheAuditOfAPointThatFlowsGoesOn) {
    ScreeningSetup setup = setup_of(3, 2e-3);
    setup.gate.flow = 4e-3, setup.audit.share = 1;
    auto bench = screening(3, setup);
    auto reference = full(3);
    shear(bench, 900), shear(reference, 900);
    ASSERT_EQ(bench.law.mode(2), PointMode::flow);
    EXPECT_NEAR(bench.law.audited_error(2), share(bench.stress[2], reference.stress[2]), 0.02);
    const auto of_it = [](const RveUpdate& u) { return u.point == 2; };
    bench.law.watch_audits();
    for (int k = 0; k < 100; ++k) {
        shear(bench, 1);
        EXPECT_TRUE(std::ranges::none_of(bench.law.watched_updates(), of_it)) << "its log has a gap";
    }
}

TEST(ScreeningLaw, AuditsChangeNoBitOfTheGround) {
    ScreeningSetup looked = setup_of(4, 3e-3), alone = looked;
    looked.audit.share = 1;
    auto a = screening(4, looked), b = screening(4, alone);
    shear(a, 700), shear(b, 700);
    EXPECT_EQ(a.stress, b.stress);
    a.law.audit_now(1);
    EXPECT_GT(a.law.audits().back().points, 0);
    EXPECT_GT(a.law.audits().back().mean, 0);
    EXPECT_GT(a.law.screening().audit_steps, 0);
    EXPECT_TRUE(std::isnan(b.law.audited_error(0)));
}

TEST(ScreeningLaw, TheAuditSeesTheErrorThatIsThere) {
    ScreeningSetup setup = setup_of(3, 1);
    setup.audit.share = 1;
    auto bench = screening(3, setup);
    auto reference = full(3);
    shear(bench, 800), shear(reference, 800);
    EXPECT_NEAR(bench.law.audited_error(2), share(bench.stress[2], reference.stress[2]), 0.05);
}

class BrokenSurrogate : public testing::TestWithParam<double> {};

TEST_P(BrokenSurrogate, IsReplacedByTheGrains) {
    ScreeningSetup setup = setup_of(3, 1);
    setup.gate.active = false;
    setup.surrogate = std::make_shared<Breaking>(GetParam());
    auto bench = screening(3, setup);
    auto reference = full(3);
    shear(bench, 900), shear(reference, 900);
    ASSERT_EQ(bench.law.mode(2), PointMode::grains);
    EXPECT_LT(share(bench.stress[2], reference.stress[2]), 0.05);
    EXPECT_EQ(bench.law.switches()[0].reason, Reason::failed_answer);
    EXPECT_GE(bench.law.screening().failed_answers, 1);
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
        bench.law.predict(bench.batch()), bench.law.route(bench.batch());
        bench.law.ask(bench.batch()), bench.law.drive(bench.batch());
        bench.law.hand_over(bench.batch(), {bench.x, bench.y, bench.volume, 1, 1e-3 * k});
    }
    for (std::size_t p = 0; p < 6; ++p) EXPECT_EQ(bench.law.by_grains(p), p >= 2 && p <= 4) << p;
    for (const Switch& s : bench.law.switches())
        EXPECT_EQ(s.reason, s.point == 3 ? Reason::strain : Reason::neighbour);
    EXPECT_NE(bench.law.screening().jump_work, 0);
}

}  // namespace
}  // namespace sandgraph::graph
