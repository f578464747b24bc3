#pragma once
#include <span>

#include "mpm/grid.hpp"
#include "mpm/points.hpp"
#include "mpm/transfer_kernel.hpp"

namespace sandgraph::mpm {

// Moves the cuts with their bodies and sizes the second field around them. Before the points' order is
// refreshed. `half`: of the points' domains [m]. Where a body is thick the soil on its two sides shares no
// node, and nothing is cut.
void set_bodies(Grid& grid, std::span<const Enrichment> bodies, double half);

// The transfers of transfer_kernel.hpp for the few points near the cut, each node in its field; in id
// order.
void scatter_enriched(std::span<const std::int32_t> ids, const Points& points, std::span<const Stress> stress,
                      Grid& grid);
void gather_enriched(std::span<const std::int32_t> ids, const Grid& grid, const Advance& advance,
                     Points& points);

}  // namespace sandgraph::mpm
