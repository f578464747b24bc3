#include "mpm/transfer.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "base/contracts.hpp"
#include "mpm/parallel_bands.hpp"
#include "mpm/transfer_kernel.hpp"
#include "mpm/two_field.hpp"

namespace sandgraph::mpm {
namespace {

int band_of_first(std::span<const std::int32_t> ids, const Points& points, const GridShape& shape) {
    return band_of(base_row(shape, points.half, points.y[static_cast<std::size_t>(ids[0])]));
}

// Whether a point that was in band `before` is in another band now, or outside the grid.
bool moved_on(int before, std::span<const std::int32_t> ids, const Points& points, const GridShape& shape) {
    const double low = before * band_rows - 1, high = low + band_rows;
    bool moved = false;
    for (const auto id : ids) {
        const auto p = static_cast<std::size_t>(id);
        const double row = base_row(shape, points.half, points.y[p]);
        moved |= !(row >= low) | !(row < high) | !shape.contains(points.x[p], points.y[p]);
    }
    return moved;
}

bool any_outside(std::span<const std::int32_t> ids, const Points& points, const GridShape& shape) {
    return std::ranges::any_of(ids, [&](std::int32_t id) {
        const auto p = static_cast<std::size_t>(id);
        return !shape.contains(points.x[p], points.y[p]);
    });
}

Status count_outside(const Points& points, const GridShape& shape) {
    Status status;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (shape.contains(points.x[p], points.y[p])) continue;
        if (status.outside++ == 0) status.first = static_cast<std::int32_t>(p);
    }
    return status;
}

}  // namespace

void points_to_grid(const Points& points, std::span<const Stress> stress, const Order& order, Grid& grid) {
    if (order.stale) throw std::logic_error("points_to_grid: refresh the order of the points first");
    SG_EXPECT(order.is_near.size() == points.size());
    SG_EXPECT(grid.fields[0].nodes.size() == grid.shape.size());
    clear(grid);
    grid.point_mass = points.size() ? points.mass.front() / share(points, 0) : 0;
    Node* const nodes = grid.fields[0].nodes.data();
    const auto add = [&](std::span<const std::int32_t> ids) {
        scatter(ids, points, stress, grid.shape, nodes);
    };
    for_bands(order, 0, 2, add);
    for_bands(order, 1, 2, add);
    scatter_enriched(order.near, points, stress, grid);
}

Status grid_to_points(const Grid& grid, const Advance& advance, Order& order, Points& points) {
    SG_EXPECT(order.is_near.size() == points.size() && !order.stale);
    SG_EXPECT(advance.dt > 0 && advance.pic >= 0 && advance.pic <= 1);
    std::atomic<bool> moved = false;
    const Motion* const motion = grid.fields[0].motion.data();
    for_bands(order, 0, 1, [&](std::span<const std::int32_t> ids) {
        const int before = band_of_first(ids, points, grid.shape);  // a whole band may move on together
        gather(ids, grid.shape, motion, advance, points);
        if (moved_on(before, ids, points, grid.shape)) moved.store(true, std::memory_order_relaxed);
    });
    gather_enriched(order.near, grid, advance, points);
    if (any_outside(order.near, points, grid.shape)) moved = true;
    order.stale = moved;
    return moved ? count_outside(points, grid.shape) : Status{};
}

}  // namespace sandgraph::mpm
