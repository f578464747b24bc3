#include "mpm/layout.hpp"

#include <gtest/gtest.h>

#include "mpm/audit.hpp"
#include "tests/support/memory_archive.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

TEST(Layout, FillsTheGroundButNotThePlate) {
    const Rectangle plate{0.5, 0.5, 1.5, 0.6};
    for (const int per_cell : {1, 4, 9}) {
        const Points points = lay_out({{0, 0, 2, 1}, 0.1, per_cell, 2000, {plate}});
        EXPECT_NEAR(total_mass(points), 2000 * (2.0 - 0.1), 1e-9);
        for (std::size_t p = 0; p < points.size(); ++p)
            EXPECT_FALSE(plate.contains(points.x[p], points.y[p]));
    }
}

TEST(Layout, RowsCountFromTheSurface) {
    const Points points = lay_out({{0, 0, 2, 1}, 0.1, 4, 2000, {}});
    for (std::size_t p = 0; p < points.size(); ++p)
        EXPECT_NEAR(1 - points.y[p], (points.row[p] + 0.5) * 2 * points.half, 1e-14);
    ASSERT_EQ(points.surface.size(), 40u);
    for (const auto id : points.surface) EXPECT_EQ(points.row[static_cast<std::size_t>(id)], 0);
}

// Columns on the sides, so that the plate's ends come to lie on points: each keeps its half outside.
TEST(Layout, APointAtTheEndOfAPlateIsHalved) {
    const Rectangle plate{-0.5, 0.5, 0.5, 0.6};
    const Points points =
        lay_out({.ground = {0, 0, 2, 1}, .density = 2000, .cavities = {plate}, .columns_on_sides = true});
    EXPECT_NEAR(total_mass(points), 2000 * (2.0 - 0.05), 1e-9);
    int halved = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (points.cut[p] == 0) continue;
        ++halved;
        EXPECT_EQ(points.cut[p], -1) << "the half to the left lies in the plate";
        EXPECT_NEAR(points.x[p], 0.5, 1e-12);
        EXPECT_NEAR(points.y[p], 0.55, 1e-12);
        EXPECT_NEAR(share(points, p), 0.5, 1e-12);
    }
    EXPECT_EQ(halved, 1);
}

// The footing's end comes to lie on a surface point: the surcharge acts on its half outside.
TEST(Layout, ABodyTakesThePlaceOfTheSurchargeToItsEnd) {
    const Points points = lay_out({.ground = {0, 0, 2, 1},
                                   .density = 2000,
                                   .cavities = {{-0.5, 1, 0.5, 1.4}},
                                   .columns_on_sides = true});
    ASSERT_EQ(points.bare.size(), points.surface.size());
    double bare = 0;
    for (std::size_t k = 0; k < points.surface.size(); ++k)
        bare += points.bare[k] * share(points, static_cast<std::size_t>(points.surface[k])) * 2 * points.half;
    EXPECT_NEAR(bare, 1.5, 1e-12);
}

TEST(Layout, NoPointLiesBetweenTwoBodiesThatMeetAtIt) {
    const Points points = lay_out({.ground = {0, 0, 2, 1},
                                   .density = 2000,
                                   .cavities = {{-0.5, 0, 0.5, 0.4}, {0.5, 0, 2, 0.4}},
                                   .columns_on_sides = true});
    EXPECT_NEAR(total_mass(points), 2000 * 2.0 * 0.6, 1e-9);
    for (std::size_t p = 0; p < points.size(); ++p) EXPECT_EQ(points.cut[p], 0);
}

TEST(PointsArchive, BringsEveryBitBack) {
    Points points = support::random_ground(5, 6, 4, 11), copy = support::random_ground(5, 6, 4, 12);
    points.F[3] << 1.25, 0.5, -0.25, 0.75;
    points.F_inc[4] << 1.01, 0.02, -0.03, 0.99;
    support::MemoryArchive memory;
    archive(memory, points);
    memory.read_from_now_on();
    archive(memory, copy);
    EXPECT_EQ(copy.half, points.half);
    for (auto field :
         {&Points::x, &Points::y, &Points::vx, &Points::vy, &Points::mass, &Points::volume0, &Points::volume})
        EXPECT_EQ(copy.*field, points.*field);
    EXPECT_EQ(copy.F, points.F);
    EXPECT_EQ(copy.F_inc, points.F_inc);
    EXPECT_EQ(copy.stress, points.stress);
    EXPECT_EQ(copy.row, points.row);
    EXPECT_EQ(copy.surface, points.surface);
}

TEST(PointsArchive, RefusesAnotherGround) {
    const auto read_into = [](Points other) {
        Points points = support::random_ground(5, 6, 4, 11);
        support::MemoryArchive memory;
        archive(memory, points);
        memory.read_from_now_on();
        archive(memory, other);
    };
    EXPECT_NO_THROW(read_into(support::random_ground(5, 6, 4, 12)));
    EXPECT_THROW(read_into(support::random_ground(4, 6, 4, 12)), StateError) << "fewer points";
    EXPECT_THROW(read_into(support::random_ground(6, 5, 4, 12)), StateError) << "as many points, other rows";
}

}  // namespace
}  // namespace sandgraph::mpm
