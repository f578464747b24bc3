#include <gtest/gtest.h>

#include <cstdlib>

#include "packings/compressed_packings.hpp"
#include "packings/history_row.hpp"
#include "packings/in_situ.hpp"
#include "tests/unit/io/scratch.hpp"

// The ground of a law without grains, and the rows of the history log.
namespace sandgraph::packings {
namespace {

scene::Scene ground(scene::Law law) {
    scene::Scene s;
    s.domain = {2, 1, 0.1, 4};
    s.ground.law = law, s.ground.surcharge = 7e3, s.ground.gravity = 10;
    s.ground.continuum.density = 1900, s.ground.continuum.friction_angle = 0.6;
    return s;
}

// Rows of half a cell; each point stands for the middle of its row.
TEST(ClosedFormGround, PressureIsThatOfTheMiddleOfEachRowUnderTheSurcharge) {
    const PreparedGround made = prepare_ground(ground(scene::Law::elastic));
    ASSERT_EQ(made.row_pressure.size(), 20u);
    for (std::size_t row = 0; row < 20; ++row)
        EXPECT_NEAR(made.row_pressure[row], 7e3 + 1900 * 10 * (0.025 + 0.05 * double(row)), 1e-6);
    EXPECT_EQ(made.density, 1900);
}

TEST(ClosedFormGround, HasTheFrictionAngleOfItsLawIfThatHasOne) {
    EXPECT_EQ(prepare_ground(ground(scene::Law::elastic)).friction_angle, 0);
    EXPECT_EQ(prepare_ground(ground(scene::Law::mohr_coulomb)).friction_angle, 0.6);
}

// Each row has a packing under its own pressure, and all the density of the one at mid-depth.
TEST(GroundOfGrains, HasAPackingForTheWeightAboveEachRow) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    scene::Scene s = ground(scene::Law::rve);
    s.domain = {1, 0.8, 0.2, 1};
    s.ground.grains.count = 30;
    const PreparedGround made = prepare_ground(s);
    ASSERT_EQ(made.packings.size(), 4u);
    for (std::size_t row = 0; row < 4; ++row) {
        EXPECT_NEAR(made.row_pressure[row], 7e3 + made.density * 10 * (0.1 + 0.2 * double(row)), 1e-6);
        EXPECT_NEAR(0.5 * made.packings[row].packing->stress.trace(), made.row_pressure[row],
                    0.01 * made.row_pressure[row]);
    }
    const dem::Packing middle = CompressedPackings(s.ground.grains).at(made.row_pressure[2]);
    EXPECT_NEAR(made.density, 2650 * (1 - dem::porosity(middle)), 2);
}

TEST(HistoryRow, HoldsWhatThePackingShows) {
    dem::RveUpdate u;
    u.stress << 30, 2, 4, 50;
    u.seen.porosity = 0.2, u.seen.kinetic_translation = 3, u.seen.kinetic_rotation = 4;
    u.seen.fabric << 0.6, 0.1, 0.1, 0.4;
    u.report.dem_steps = 12, u.volume_ratio = 1.01;
    const io::HistoryRow row = history_row(u);
    EXPECT_FLOAT_EQ(row.p, 40);
    EXPECT_FLOAT_EQ(row.q, static_cast<float>(std::hypot(10, 3)));
    EXPECT_FLOAT_EQ(row.void_ratio, 0.25f);
    EXPECT_FLOAT_EQ(row.energy[3], 7);
    EXPECT_FLOAT_EQ(row.fabric[1], 0.4f);
    EXPECT_EQ(row.dem_steps, 12);
    EXPECT_EQ(row.volume_ratio, 1.01);
}

}  // namespace
}  // namespace sandgraph::packings
