#pragma once
#include <span>

#include "mpm/advance_point.hpp"
#include "mpm/grid.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

// Vectorised transfers of the points `ids` to and from field 0, for the widest instruction set of the
// machine. Each id is a point's and its stencil lies in the grid (refresh sees to that); `nodes` and `motion`
// [shape.size()] are by node index. Bands that share nodes must not be handed over at once.
void scatter(std::span<const std::int32_t> ids, const Points& points, std::span<const Stress> stress,
             const GridShape& shape, Node* nodes);
void gather(std::span<const std::int32_t> ids, const GridShape& shape, const Motion* motion,
            const Advance& advance, Points& points);

}  // namespace sandgraph::mpm
