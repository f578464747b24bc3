#pragma once
#include "mpm/grid.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

// mirror: roller or symmetry plane; the model behaves like one half of the mirrored whole. fixed: no motion.
// free: nothing.
enum class Side { free, mirror, fixed };

// The sides lie on the outermost nodes; along an axis that is `between` they lie midway between the outermost
// nodes, which then are images, and the next.
struct Boundaries {
    Side left = Side::free, right = Side::free, bottom = Side::free, top = Side::free;
    bool between_x = false, between_y = false;
};

// Before the update: what points gave to images goes to their originals, normal components reversed.
void fold(Field& field, const GridShape& shape, const Boundaries& boundaries);

// After the update: velocity and acceleration on the sides and of the images, such that v_old + dt a = v.
void constrain(Field& field, const GridShape& shape, const Boundaries& boundaries, double dt);

// A pressure q [Pa] on the ground surface, a dead load: each surface point carries q times its initial width
// down. It acts on the top edge of the point's domain, where uniform GIMP's internal force ends, so that a
// point under the stress -q balances it exactly. After points_to_grid, before update_grid.
void add_surcharge(double q, const Points& points, Grid& grid);

}  // namespace sandgraph::mpm
