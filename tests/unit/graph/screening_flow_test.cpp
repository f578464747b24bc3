#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/unit/graph/screening_bench.hpp"

namespace sandgraph::graph {
namespace {

const stress::Switch& last_switch(const ScreeningLaw& law, std::int32_t point) {
    const auto of_point = [&](const stress::Switch& s) { return s.point == point; };
    return *std::find_if(law.screening_log()->switches.rbegin(), law.screening_log()->switches.rend(),
                         of_point);
}

// At 7.2e-3 of strain it has been by grains from 2e-3 to 4e-3; 40 steps later nothing is left of the jump.
TEST(ScreeningLaw, APointThatFlowsGoesBackToTheSurrogateThatHasFollowedIt) {
    ScreeningSetup setup = setup_of(3, 2e-3), alone = setup;
    setup.gate.flow = 4e-3, alone.gate.active = false;
    auto bench = screening(3, setup), surrogate = screening(3, alone);
    shear(bench, 800), shear(surrogate, 800);
    ASSERT_EQ(bench.law.modes()[2], PointMode::critical_state);
    EXPECT_EQ(last_switch(bench.law, 2).reason, Reason::critical_state);
    EXPECT_FALSE(bench.law.modes().by_grains(2));
    const std::int64_t paid = bench.law.grain_use().dem_steps;
    bench.F[1] = Mat2::Identity(), shear(surrogate, 150);
    for (int k = 0; k < 150; ++k) bench.law.update(bench.batch());
    EXPECT_EQ(bench.law.grain_use().dem_steps, paid);
    EXPECT_LT(share(bench.stress[2], surrogate.stress[2]), 0.02) << "each within its tolerance of 0.01";
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
    ASSERT_EQ(last_switch(bench.law, 2).reason, Reason::critical_state);
    double jumps = 0;
    for (const stress::Switch& s : bench.law.screening_log()->switches) jumps += s.jump * 32e3;
    EXPECT_LT(largest, 0.05 * jumps + 0.03 * 32e3);
}

// Read off the stresses from outside, in the 40 steps that a jump fades and the 40 after them.
TEST(ScreeningLaw, TellsWhatTheGroundFeelsOfAJump) {
    ScreeningSetup setup = setup_of(3, 2e-3);
    setup.gate.flow = 0;
    auto bench = screening(3, setup);
    while (!bench.law.modes().by_grains(2)) shear(bench, 1);
    std::array<double, 2> largest{};
    for (int k = 0; k < 80; ++k) {
        const Stress before = bench.stress[2];
        shear(bench, 1);
        const double change = norm(difference(bench.stress[2], before)) / mean_stress(bench.stress[2]);
        largest[k / 40] = std::max(largest[k / 40], change);
    }
    shear(bench, 20);
    EXPECT_DOUBLE_EQ(last_switch(bench.law, 2).felt, largest[0]);
    EXPECT_DOUBLE_EQ(last_switch(bench.law, 2).ordinary, largest[1]);
    EXPECT_GE(largest[0], last_switch(bench.law, 2).jump / 40 - largest[1]);
}

// Answers until it is told not to.
struct Mortal : support::ElementSurrogate {
    void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc, std::span<double> states,
                std::span<stress::SurrogateAnswer> answers) const override {
        ElementSurrogate::update(points, F_inc, states, answers);
        for (stress::SurrogateAnswer& a : answers)
            if (dead) a.stress.xx = std::numeric_limits<double>::quiet_NaN();
    }
    bool dead = false;
};

TEST(ScreeningLaw, ASurrogateThatFailsWhileItsJumpFadesIsReplacedAgain) {
    ScreeningSetup setup = setup_of(3, 2e-3);
    const auto mortal = std::make_shared<Mortal>();
    setup.gate.flow = 4e-3, setup.surrogate = mortal, setup.hand_over.blend_steps = 41;
    auto bench = screening(3, setup);
    while (bench.law.modes()[2] != PointMode::critical_state) shear(bench, 1);
    mortal->dead = true;
    shear(bench, 200);
    EXPECT_EQ(bench.law.modes()[2], PointMode::grains);
    for (const Stress& s : bench.stress) EXPECT_TRUE(std::isfinite(norm(s)));
    EXPECT_LT(norm(bench.stress[2]), 5 * 32e3);
}

// Its second packing takes over what its grains have been through.
TEST(ScreeningLaw, TheAuditOfAPointThatFlowsGoesOn) {
    ScreeningSetup setup = setup_of(3, 2e-3);
    setup.gate.flow = 4e-3, setup.audit.share = 1;
    auto bench = screening(3, setup);
    auto reference = full(3);
    shear(bench, 900), shear(reference, 900);
    ASSERT_EQ(bench.law.modes()[2], PointMode::critical_state);
    EXPECT_NEAR(bench.law.observe(2).audited_error, share(bench.stress[2], reference.stress[2]), 0.02);
    const auto of_it = [](const dem::RveUpdate& u) { return u.point == 2; };
    bench.law.watch({});
    for (int k = 0; k < 100; ++k) {
        shear(bench, 1);
        EXPECT_TRUE(std::ranges::none_of(watched(bench.law), of_it)) << "its log has a gap";
    }
}

}  // namespace
}  // namespace sandgraph::graph
