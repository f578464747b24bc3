#include <gtest/gtest.h>

#include "tests/support/random_ground.hpp"
#include "tests/support/random_step.hpp"

namespace sandgraph {
namespace {

// A random ground in x > 0 and the same with its mirror image in x < 0 (ids doubled).
mpm::Points half_ground() {
    mpm::Points points = support::random_ground(8, 10, 4, 21);
    for (double& x : points.x) x -= 0.15;
    for (double& x : points.x) x = x < 0.01 ? 0.01 : x;
    return points;
}

mpm::Points with_image(const mpm::Points& half) {
    mpm::Points whole = half;
    const std::size_t n = half.size();
    mpm::resize(whole, 2 * n);
    for (std::size_t p = 0; p < n; ++p) {
        whole.x[n + p] = -half.x[p], whole.y[n + p] = half.y[p];
        whole.vx[n + p] = -half.vx[p], whole.vy[n + p] = half.vy[p];
        whole.mass[n + p] = half.mass[p];
        whole.volume0[n + p] = half.volume0[p], whole.volume[n + p] = half.volume[p];
        whole.stress[n + p] = {half.stress[p].xx, half.stress[p].yy, -half.stress[p].xy};
    }
    return whole;
}

mpm::Points moved(const mpm::Points& points, const mpm::GridShape& grid, mpm::Side left) {
    graph::StepSettings settings;
    settings.dt = 1e-4, settings.gravity = {0, -9.81};
    settings.scheme.damping = 0.1, settings.scheme.mass_scaling = 2, settings.scheme.pic_fraction = 0.02;
    settings.boundaries = {left, mpm::Side::free, mpm::Side::fixed, mpm::Side::free};
    support::RandomStep ground(settings, points, grid);
    ground.steps(20);
    return ground.state().points;
}

TEST(Mirror, HalfModelMovesAsTheWhole) {
    const mpm::Points start = half_ground();
    const mpm::Points half = moved(start, {0, 0, 0.1, 20, 20}, mpm::Side::mirror),
                      whole = moved(with_image(start), {-2, 0, 0.1, 40, 20}, mpm::Side::free);
    for (std::size_t p = 0; p < half.size(); ++p) {
        EXPECT_NEAR(half.x[p], whole.x[p], 1e-12);
        EXPECT_NEAR(half.vx[p], whole.vx[p], 1e-9);
        EXPECT_NEAR(half.vy[p], whole.vy[p], 1e-9);
        EXPECT_LT((half.F[p] - whole.F[p]).norm(), 1e-10);
    }
}

}  // namespace
}  // namespace sandgraph
