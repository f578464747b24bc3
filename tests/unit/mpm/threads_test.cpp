#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include "mpm/contact.hpp"
#include "mpm/grid_update.hpp"
#include "mpm/transfer.hpp"
#include "mpm/two_field.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

// Forty steps of a ground with frozen random stresses and a moving plate in it.
Points run() {
    Points points = support::random_ground(40, 80, 4, 9);
    Grid grid(support::grid_around(40, 80));
    RigidPlate plate{2.2, 4, 0.5, 0.05, {0, 0.5}, 0.5, 1e8, {}};
    Contact contact = make_contact(points.size());
    Order order;
    const GridStep update{1e-4, {0, -9.81}, 0.05, 1, {Side::mirror, Side::mirror, Side::fixed, Side::free}};
    for (int k = 0; k < 40; ++k) {
        set_enrichment(grid, enrichment_of(plate), points.half);
        refresh(order, points, grid);
        points_to_grid(points, order, grid);
        add_contact(plate, points, order, grid, contact);
        update_grid(update, grid);
        advance_slip(plate, grid, update.dt, contact);
        advance(plate, update.dt);
        EXPECT_TRUE(grid_to_points(grid, {update.dt, 0.01}, order, points).good());
    }
    return points;
}

Points run(int threads) {
    oneapi::tbb::task_arena arena(threads);
    return arena.execute([] { return run(); });
}

TEST(Threads, DoNotChangeABit) {
    const oneapi::tbb::global_control four(oneapi::tbb::global_control::max_allowed_parallelism, 4);
    const Points one = run(1);
    for (const int threads : {2, 4}) {
        const Points many = run(threads);
        for (auto field : {&Points::x, &Points::y, &Points::vx, &Points::vy, &Points::volume})
            EXPECT_EQ(many.*field, one.*field) << threads;
        EXPECT_EQ(many.F, one.F);
    }
}

}  // namespace
}  // namespace sandgraph::mpm
