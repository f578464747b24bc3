#pragma once
#include "mpm/grid_update.hpp"

namespace sandgraph::mpm {

// Work [J/m] of forces on the nodes over a step, with the velocities that points read back; what the nodes'
// kinetic energy s m v^2/2 takes up in it is exactly `gained`.
struct NodeWork {
    double damping = 0;  // taken by local damping
    double gained = 0;   // done by all forces, damping and sides included

    NodeWork& operator+=(const NodeWork& other);
};

// After update_grid, of the same step; sums in the order of the nodes.
NodeWork node_work(const GridStep& step, const Grid& grid);

}  // namespace sandgraph::mpm
