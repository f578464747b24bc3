#include "mpm/grid_update.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "base/contracts.hpp"
#include "mpm/light_nodes.hpp"

namespace sandgraph::mpm {
namespace {

// Lighter nodes are at rest: a weight of 1e-14 is round-off at the end of a stencil, its velocity would be
// noise.
constexpr double mass_floor = 1e-14;

struct Factors {
    double dt, gx, gy, damping, per_scaling, floor;
};

// Damping force. `v` is the velocity that the undamped step would end with: the sign of a node's velocity at
// rest would be that of round-off, and the damping of its first motion a matter of luck.
double against(double v, double f, double damping) {  // docs/how_it_works.md (eq. 6)
    return v != 0 ? std::copysign(damping * std::fabs(f), v) : 0;
}

Motion moved(const Node& n, const Factors& k) {  // (eqs. 5 to 7)
    if (n.mass <= k.floor) return {};
    const double per_mass = 1 / n.mass, vx = n.px * per_mass, vy = n.py * per_mass;
    const double fx = n.fx + n.mass * k.gx, fy = n.fy + n.mass * k.gy;
    const double per_inertia = per_mass * k.per_scaling;
    const double ax = (fx - against(vx + k.dt * fx * per_inertia, fx, k.damping)) * per_inertia;
    const double ay = (fy - against(vy + k.dt * fy * per_inertia, fy, k.damping)) * per_inertia;
    return {vx + k.dt * ax, vy + k.dt * ay, ax, ay};
}

void move_rows(Field& field, const GridShape& shape, const Factors& k, int from, int to) {
    for (int j = from; j < to; ++j) {
        const std::size_t first = shape.index(field.box.i0, j), last = shape.index(field.box.i1, j);
        for (std::size_t n = first; n <= last; ++n) field.motion[n] = moved(field.nodes[n], k);
    }
}

void move_field(const GridShape& shape, const Factors& k, Field& field) {
    const NodeBox& box = field.box;
    if (box.empty()) return;
    constexpr int rows = 16;
    if ((box.j1 - box.j0) * (box.i1 - box.i0) < 4000)
        move_rows(field, shape, k, box.j0, box.j1 + 1);
    else
        oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(box.j0, box.j1 + 1, rows),
                                  [&](const auto& r) { move_rows(field, shape, k, r.begin(), r.end()); });
}

void constrain_all(const GridStep& step, Grid& grid) {
    for (Field& field : grid.fields) constrain(field, grid.shape, step.boundaries, step.dt);
}

}  // namespace

void update_grid(const GridStep& step, Grid& grid) {
    SG_EXPECT(step.dt > 0 && step.mass_scaling > 0);
    SG_EXPECT(step.damping >= 0 && step.damping < 1);
    const Factors k = {step.dt,      step.gravity.x(),      step.gravity.y(),
                       step.damping, 1 / step.mass_scaling, mass_floor * grid.point_mass};
    for (Field& field : grid.fields) fold(field, grid.shape, step.boundaries);
    const std::vector<Follower> followers = find_followers(grid, step.boundaries, step.light);
    give(followers, grid);
    for (Field& field : grid.fields) move_field(grid.shape, k, field);
    constrain_all(step, grid);
    if (followers.empty()) return;
    follow(followers, grid);
    constrain_all(step, grid);  // a follower on a wall keeps to it
}

}  // namespace sandgraph::mpm
