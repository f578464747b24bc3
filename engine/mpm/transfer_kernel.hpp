#pragma once
#include <span>

#include "mpm/advance_point.hpp"
#include "mpm/grid.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

// Vectorised transfers of the points `ids` to and from field 0, for the widest instruction set of the
// machine.
void scatter(std::span<const std::int32_t> ids, const Points& points, const GridShape& shape, Node* nodes);
void gather(std::span<const std::int32_t> ids, const GridShape& shape, const Motion* motion,
            const Advance& advance, Points& points);

}  // namespace sandgraph::mpm
