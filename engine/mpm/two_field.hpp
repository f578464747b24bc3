#pragma once
#include <span>

#include "mpm/grid.hpp"
#include "mpm/points.hpp"
#include "mpm/transfer_kernel.hpp"

namespace sandgraph::mpm {

// Moves the cut with the plate and sizes the second field around it. Before the points' order is refreshed.
// `half`: of the points' domains [m]. Without an active cut no node is enriched.
void set_enrichment(Grid& grid, const Enrichment& enrichment, double half);

// The transfers of transfer_kernel.hpp for the few points near the cut, each node in its field; in id
// order.
void scatter_enriched(std::span<const std::int32_t> ids, const Points& points, Grid& grid);
void gather_enriched(std::span<const std::int32_t> ids, const Grid& grid, const Advance& advance,
                     Points& points);

}  // namespace sandgraph::mpm
