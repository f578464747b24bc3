#include "mpm/order.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mpm/transfer.hpp"
#include "mpm/two_field.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

TEST(Order, HoldsEveryPointOnceInItsBand) {
    const Points points = support::random_ground(20, 60, 4, 3);
    Grid grid(support::grid_around(20, 60));
    set_bodies(grid, std::array{Enrichment{true, true, 3, 0.8, 1.6, 0.05}}, points.half);
    Order order;
    refresh(order, points, grid);
    std::set<std::int32_t> seen(order.near.begin(), order.near.end());
    EXPECT_GT(seen.size(), 0u);
    for (std::size_t b = 0; b < order.bands(); ++b)
        for (auto k = static_cast<std::size_t>(order.first[b]);
             k < static_cast<std::size_t>(order.first[b + 1]); ++k) {
            const auto p = static_cast<std::size_t>(order.ids[k]);
            EXPECT_EQ(band_of(base_row(grid.shape, points.half, points.y[p])), static_cast<int>(b));
            EXPECT_TRUE(seen.insert(order.ids[k]).second);
        }
    EXPECT_EQ(seen.size(), points.size());
}

// A restart rebuilds the order from the positions: it must be the one that the run had.
TEST(Order, KeptUpToDateOverAMovingRunIsTheOneBuiltAfresh) {
    Points points = support::random_ground(10, 40, 1, 3);
    Grid grid(support::grid_around(10, 40));
    for (Motion& m : grid.fields[0].motion) m = {0, 0.5, 0, 0};
    Order order;
    for (int k = 0; k < 40; ++k) {
        set_bodies(grid, std::array{Enrichment{true, true, 2 + 0.01 * k, 0.4, 1.0, 0.05}}, points.half);
        refresh(order, points, grid);
        Order fresh;
        refresh(fresh, points, grid);
        ASSERT_EQ(order.ids, fresh.ids);
        ASSERT_EQ(order.near, fresh.near);
        for (auto& field : grid.fields) field.motion.assign(grid.shape.size(), {0, 0.5, 0, 0});
        ASSERT_TRUE(grid_to_points(grid, {0.005, 0}, order, points).good());
    }
}

// One row of points just above a band's edge that sinks below it in one step: no point is left to differ
// from.
TEST(Order, NoticesABandWhosePointsAllLeaveTogether) {
    Grid grid(support::grid_around(10, 40));
    const GridShape& shape = grid.shape;
    Points points = support::random_ground(10, 40, 1, 3);
    const double edge = shape.y0 + (band_rows - 1) * shape.cell + points.half;  // base row 7 begins band 1
    resize(points, 5);
    for (std::size_t p = 0; p < 5; ++p)
        points.x[p] = shape.x0 + (3 + static_cast<double>(p)) * shape.cell, points.y[p] = edge + 1e-9;
    Order order;
    refresh(order, points, grid);
    for (Motion& m : grid.fields[0].motion) m = {0, -0.5, 0, 0};
    ASSERT_TRUE(grid_to_points(grid, {1e-6, 0}, order, points).good());
    refresh(order, points, grid);
    Order fresh;
    refresh(fresh, points, grid);
    EXPECT_EQ(order.first, fresh.first);
}

}  // namespace
}  // namespace sandgraph::mpm
