#pragma once
#include "mpm/grid.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

// A pressure q [Pa] on the ground surface, a dead load: each surface point carries q times its initial width
// down. It acts on the top edge of the point's domain, where uniform GIMP's internal force ends, so that a
// point under the stress -q balances it exactly. After points_to_grid, before update_grid.
void add_surcharge(double q, const Points& points, Grid& grid);

}  // namespace sandgraph::mpm
