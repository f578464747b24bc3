#include <gtest/gtest.h>

#include <cmath>

#include "scene/expected_ground.hpp"
#include "scene/read_scene.hpp"

// How fast a plate is pulled whose scene does not say.
namespace sandgraph::scene {
namespace {

// M = 1.2e8 Pa, c = 244.9 m/s at 2000 kg/m3.
Scene with(std::vector<std::string> set) {
    for (const char* common : {"ground.law=mohr_coulomb", "continuum.young=80 MPa",
                               "continuum.poisson=0.333333333333333", "continuum.density=2000 kg/m3"})
        set.emplace_back(common);
    return parse_scene("", "s.toml", set);
}

TEST(DefaultPullRate, IsThePapersWhereThatIsSlow) {
    EXPECT_EQ(with({"ground.surcharge=100 kPa"}).anchor.pull_rate, 0.05);
}

// 0.25 (2000 9.81 3 + q) / (2000 244.9).
TEST(DefaultPullRate, KeepsTheWavePressureBelowAShareOfThatOnThePlate) {
    EXPECT_NEAR(with({}).anchor.pull_rate, 0.25 * 58860 / (2000 * 244.949), 1e-6);
    EXPECT_NEAR(with({"ground.surcharge=10 kPa"}).anchor.pull_rate, 0.25 * 68860 / (2000 * 244.949), 1e-6);
    // Ten times the inertia: a wave as slow as the root of it, as strong as the root of it.
    EXPECT_NEAR(with({"mpm.mass_scaling=10"}).anchor.pull_rate / with({}).anchor.pull_rate, std::sqrt(0.1),
                1e-9);
}

TEST(DefaultPullRate, OfSmallPlatesFollowsTheirWeight) {
    const std::vector<std::string> small = {"anchor.width=0.5 m", "anchor.thickness=0.1 m",
                                            "anchor.embedment_ratio=3"};
    EXPECT_NEAR(with(small).anchor.pull_rate / with({}).anchor.pull_rate, 0.5, 1e-9);
}

// Soft ground: 0.0015 B c/(H + B), c = 24.49 m/s.
TEST(DefaultPullRate, LetsWavesCrossTheGroundAbove) {
    Scene soft = with({});
    soft.ground.continuum.young /= 100;
    EXPECT_NEAR(default_pull_rate(soft), 0.0015 * 24.4949 / 4, 1e-7);
}

TEST(DefaultPullRate, LeavesWhatIsWritten) {
    EXPECT_EQ(with({"anchor.pull_rate=0.2 m/s"}).anchor.pull_rate, 0.2);
    EXPECT_EQ(parse_scene("[anchor]\npull_rate = \"0.2 m/s\"\n", "s.toml").anchor.pull_rate, 0.2);
}

}  // namespace
}  // namespace sandgraph::scene
