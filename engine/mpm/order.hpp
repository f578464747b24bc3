#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "mpm/grid.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

// Fixed bands of cell rows. Bands of one colour (even, odd) share no node, so that they may run at
// once and every node still sums in one order. A pure function of the positions: a restart rebuilds it.
struct Order {
    std::vector<std::int32_t> ids;  // band after band, by id within a band; without the points near the plate
    std::vector<std::int32_t> first;  // band b holds ids[first[b]] .. ids[first[b + 1] - 1]
    std::vector<std::int32_t> near;   // points whose stencil may hold an enriched node, by id
    std::vector<std::uint8_t> is_near;
    bool stale = true;  // a point left its band since the last refresh

    std::size_t bands() const { return first.empty() ? 0 : first.size() - 1; }
};

inline constexpr int band_rows = 8;

// First of the three node rows in a point's stencil. The transfer kernels use the same expression.
inline double base_row(const GridShape& shape, double half, double y) {
    return std::floor((y - half - shape.y0) * (1 / shape.cell));
}
inline int band_of(double base) { return (static_cast<int>(base) + 1) / band_rows; }

// Brings the order up to date; cheap when nothing changed. Throws std::runtime_error if a point is outside
// the grid: transfers would write out of bounds.
void refresh(Order& order, const Points& points, const Grid& grid);

}  // namespace sandgraph::mpm
