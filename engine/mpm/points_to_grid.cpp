#include "mpm/points_to_grid.hpp"

#include <stdexcept>

#include "base/contracts.hpp"
#include "mpm/parallel_bands.hpp"
#include "mpm/transfer_kernel.hpp"
#include "mpm/two_field.hpp"

namespace sandgraph::mpm {

void points_to_grid(const Points& points, const Order& order, Grid& grid) {
    if (order.stale) throw std::logic_error("points_to_grid: refresh the order of the points first");
    SG_EXPECT(order.is_near.size() == points.size());
    SG_EXPECT(grid.fields[0].nodes.size() == grid.shape.size());
    clear(grid);
    grid.point_mass = points.size() ? points.mass.front() : 0;
    Node* const nodes = grid.fields[0].nodes.data();
    const auto add = [&](std::span<const std::int32_t> ids) { scatter(ids, points, grid.shape, nodes); };
    for_bands(order, 0, 2, add);
    for_bands(order, 1, 2, add);
    scatter_divided(order.near, points, grid);
}

}  // namespace sandgraph::mpm
