#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include "tests/support/random_ground.hpp"
#include "tests/support/random_step.hpp"

namespace sandgraph {
namespace {

using mpm::Points;

// Forty steps of a ground under random stresses with a moving plate in it.
Points run() {
    graph::StepSettings settings;
    settings.dt = 1e-4, settings.gravity = {0, -9.81};
    settings.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    support::RandomStep ground(settings, support::random_ground(40, 80, 4, 9), support::grid_around(40, 80));
    ground.state().add_body({2.2, 4, 0.5, 0.05, {0, 0.5}, 0.5, 1e8, {}});
    ground.steps(40);
    return ground.state().points;
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
}  // namespace sandgraph
