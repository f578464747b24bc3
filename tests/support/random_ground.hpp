#pragma once
#include "base/random.hpp"
#include "mpm/grid.hpp"
#include "mpm/layout.hpp"

namespace sandgraph::support {

// A block of points with random shifts, velocities and stresses: nothing in it is symmetric by chance.
inline mpm::Points random_ground(int columns, int rows, int per_cell, std::uint64_t seed, double cell = 0.1) {
    const double margin = 2 * cell;
    mpm::Points points = mpm::lay_out(
        {{margin, margin, margin + columns * cell, margin + rows * cell}, cell, per_cell, 2000, {}});
    Random random(seed);
    for (std::size_t p = 0; p < points.size(); ++p) {
        points.x[p] += random.uniform(-1, 1) * cell;
        points.y[p] += random.uniform(-1, 1) * cell;
        points.vx[p] = random.uniform(-1, 1);
        points.vy[p] = random.uniform(-1, 1);
        points.mass[p] *= random.uniform(0.5, 1.5);
        points.stress[p] = {random.uniform(-1e5, 1e5), random.uniform(-1e5, 1e5), random.uniform(-1e5, 1e5)};
    }
    return points;
}

inline mpm::GridShape grid_around(int columns, int rows, double cell = 0.1) {
    return {0, 0, cell, columns + 4, rows + 4};
}

}  // namespace sandgraph::support
