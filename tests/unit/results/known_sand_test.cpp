#include "results/known_sand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/paths.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::results {
namespace {

// A ground of one row of Table 1's dense sand with another peak friction.
packings::PreparedGround ground(double friction_deg) {
    packings::PreparedGround out;
    out.surrogate = surrogate::load_surrogate(test::source_file("/configs/models/table1.surrogate.h5"));
    out.friction_angle = friction_deg * std::numbers::pi / 180;
    stress::PackingTraits traits;
    traits.pressure = 30e3, traits.porosity = 0.16, traits.bulk = 60e6, traits.shear = 35e6;
    traits.coordination = 3.6, traits.peak_friction = std::sin(out.friction_angle);
    out.traits = {traits};
    return out;
}

TEST(KnownSand, IsThatOfTheTraining) {
    for (const double friction : {24.0, 32.0, 35.0}) {
        EXPECT_TRUE(known_sand(ground(friction)).known) << friction;
        EXPECT_EQ(unknown_sand_text(known_sand(ground(friction)), ground(friction)), "");
    }
}

TEST(KnownSand, IsNoneOfFarRougherGrains) {
    const KnownSand sand = known_sand(ground(52));
    EXPECT_FALSE(sand.known);
    EXPECT_NEAR(sand.distance, ((std::sin(52 * std::numbers::pi / 180) - 0.5) / 0.1 - 0.908) / 1.804, 0.01);
    EXPECT_NE(unknown_sand_text(sand, ground(52)).find("peak friction 52.0 deg"), std::string::npos);
}

TEST(KnownSand, IsTheWorstRow) {
    packings::PreparedGround mixed = ground(32);
    mixed.traits.push_back(mixed.traits.front());
    mixed.traits.back().pressure = 1e8;
    EXPECT_FALSE(known_sand(mixed).known);
}

}  // namespace
}  // namespace sandgraph::results
