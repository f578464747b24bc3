#include "simulation/caveats.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "scene/read_scene.hpp"
#include "simulation/estimate.hpp"
#include "simulation/scene_spec.hpp"
#include "tests/support/sand_scene.hpp"

namespace sandgraph::simulation {
namespace {

// H/B = 3 in Mohr-Coulomb ground of 30 deg: the block over the plate is 0.5 + 3 tan(30 deg) = 2.23 m wide.
const std::string kSound =
    support::sand_scene({.depth = 5, .cell = 0.1, .thickness = 0.1, .embedment_ratio = 3, .pull_to = 0.4});

std::vector<std::string> doubts(const std::vector<std::string>& set) {
    const scene::Scene scene = scene::parse_scene(kSound, "s.toml", set);
    const packings::PreparedGround ground = packings::prepare_ground(scene);
    return caveats(scene, ground, *simulation_of(scene, ground));
}

void expect_only(const std::vector<std::string>& found, const char* about) {
    ASSERT_EQ(found.size(), 1u) << about;
    EXPECT_NE(found.front().find(about), std::string::npos) << found.front();
}

TEST(Caveats, OfASoundSceneThereAreNone) { EXPECT_TRUE(doubts({}).empty()); }

TEST(Caveats, NameADomainNarrowerThanTheFailure) {
    expect_only(doubts({"domain.width=2.2 m"}), "take 2.3 m or more");
    EXPECT_TRUE(doubts({"domain.width=2.3 m"}).empty());
    // A steeper block needs less.
    EXPECT_TRUE(doubts({"domain.width=2.2 m", "continuum.friction_angle=25 deg"}).empty());
}

TEST(Caveats, NameAWedgeAheadOfAVerticalPlateThatIsCutOff) {
    const std::vector<std::string> vertical = {"anchor.orientation=vertical", "anchor.position=3.05 m",
                                               "anchor.embedment_ratio=2", "anchor.pull_to=0.1"};
    const auto with = [&](std::vector<std::string> set, const std::string& one) {
        set.push_back(one);
        return doubts(set);
    };
    // 3.05 + 0.05 + 0.1 + 2 tan(60 deg) = 6.66 m.
    expect_only(with(vertical, "domain.width=6.6 m"), "take 6.7 m or more");
    EXPECT_TRUE(with(vertical, "domain.width=6.7 m").empty());
    // Behind the plate: 2 tan(30 deg) = 1.15 m.
    std::vector<std::string> close = vertical;
    close[1] = "anchor.position=1.15 m";
    expect_only(with(close, "domain.width=6.7 m"), "behind the plate");
}

TEST(Caveats, NameALengthThatCellsDoNotResolve) {
    expect_only(doubts({"ground.internal_length=0.15 m"}), "0.15 m is 1.5 cells");
    EXPECT_TRUE(doubts({"ground.internal_length=0.2 m"}).empty());
}

TEST(Caveats, NameCoarseCells) {
    expect_only(doubts({"domain.cell=0.125 m", "domain.width=3 m", "anchor.thickness=0.125 m"}),
                "8 cells a plate width");
}

// rho c v over gamma H: sqrt(2200 44.4e6) 0.05 / (2200 9.81 3) = 0.27 at the default rate.
TEST(Caveats, NameAPlateTooFast) {
    const auto fast = doubts({"anchor.pull_rate=0.2 m/s"});
    expect_only(fast, "anchor.pull_rate = 0.2 m/s is fast");
    EXPECT_NE(fast.front().find("take 0.094 m/s or less"), std::string::npos) << fast.front();
    expect_only(doubts({"mpm.mass_scaling=10", "anchor.pull_rate=0.05 m/s"}), "is fast");
}

// Impedance times rate over the pressure at the plate: its width does not matter.
TEST(Caveats, RateShareIsThatOfThePressureAtThePlate) {
    const auto share = [](const std::vector<std::string>& set) {
        const scene::Scene scene = scene::parse_scene(kSound, "s.toml", set);
        const packings::PreparedGround ground = packings::prepare_ground(scene);
        return rate_share(scene, ground, *simulation_of(scene, ground));
    };
    const double narrow = share({}),
                 wide = share({"domain.depth=5.2 m", "anchor.width=2 m", "anchor.embedment_ratio=1.5"});
    EXPECT_GT(narrow, 0.01);
    EXPECT_NEAR(wide / narrow, 1, 1e-9);
}

scene::Scene scene_with(const std::vector<std::string>& set) {
    return scene::parse_scene(kSound, "s.toml", set);
}

TEST(Estimate, CountsPackingsByTheirGrains) {
    const auto bytes = [](const char* count) {
        const scene::Scene s = scene::parse_scene("[domain]\nwidth=\"6 m\"\ndepth=\"5 m\"\n", "s.toml",
                                                  std::vector<std::string>{count});
        return estimate(s, 1).bytes;
    };
    const double points = 3000, rows = 50;  // of each row one more, in situ
    EXPECT_NEAR(bytes("grains.count=400") - bytes("grains.count=100"), (points + rows) * 300 * 62, 1);
    EXPECT_NEAR(bytes("grains.samples=5") - bytes("grains.samples=1"), 4 * rows * 400 * 62, 1);
    EXPECT_LT(estimate(scene_with({}), 1).bytes, 1500 * 2000) << "closed-form laws have no packings";
}

TEST(Estimate, OfPreparationGrowsWithTheSamples) {
    const auto of = [](const char* samples) {
        return estimate(scene::parse_scene("", "s.toml", std::vector<std::string>{samples}), 2);
    };
    EXPECT_EQ(of("grains.samples=1").packings, 50);
    EXPECT_EQ(of("grains.samples=16").packings, 800);
    EXPECT_NEAR(of("grains.samples=16").preparation / of("grains.samples=1").preparation, 16, 1e-9);
    EXPECT_EQ(estimate(scene_with({}), 1).preparation, 0);
}

TEST(Estimate, RefusesMoreGroundThanThereIsMemoryFor) {
    const scene::Scene s = scene_with({"domain.cell=0.001 m", "domain.width=30 m", "domain.depth=20 m"});
    EXPECT_THROW(require_feasible(s, estimate(s, 2)), InputError);
    const scene::Scene small = scene_with({});
    EXPECT_NO_THROW(require_feasible(small, estimate(small, 2)));
}

// Said before packings are made.
TEST(Estimate, RefusesAPlateThatCrossesACellInAFewSteps) {
    const scene::Scene s = scene_with({"anchor.pull_rate=40 m/s"});
    EXPECT_THROW(require_feasible(s, estimate(s, 1)), InputError);
}

// Else the second row of points touches the plate at rest, too, and rest is none.
TEST(SoftContact, ThatSeveralRowsWouldTouchIsRefusedWithTheSmallestStiffness) {
    const auto refusal = [](const std::string& stiffness) -> std::string {
        const scene::Scene s = scene_with({"mpm.contact_stiffness=" + stiffness, "domain.points_per_cell=4"});
        const packings::PreparedGround ground = packings::prepare_ground(s);
        try {
            simulation_of(s, ground);
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    const std::string error = refusal("0.001");
    ASSERT_NE(error.find("several rows of points"), std::string::npos) << error;
    const std::size_t at = error.find("write ") + 6;
    const std::string least = error.substr(at, error.find(' ', at) - at);
    EXPECT_EQ(refusal(least), "accepted") << error;
    EXPECT_NE(refusal(fmt::format("{}", 0.9 * std::stod(least))), "accepted");
    EXPECT_EQ(refusal("1"), "accepted");
}

TEST(Estimate, OfStepsIsThatOfTheRun) {
    const scene::Scene s = scene_with({"anchor.pull_to=0.02"});
    const packings::PreparedGround ground = packings::prepare_ground(s);
    const auto simulation = simulation_of(s, ground);
    while (simulation->mark() < end_mark(s)) simulation->step();
    EXPECT_NEAR(estimate(s, 1).steps / static_cast<double>(simulation->steps()), 1, 0.05);
}

}  // namespace
}  // namespace sandgraph::simulation
