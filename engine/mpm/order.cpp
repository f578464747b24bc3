#include "mpm/order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

void require_inside(const Points& points, const GridShape& shape) {
    for (std::size_t p = 0; p < points.size(); ++p)
        if (!shape.contains(points.x[p], points.y[p]))
            throw std::runtime_error(fmt::format("material point {} at ({:.6g}, {:.6g}) m left the grid", p,
                                                 points.x[p], points.y[p]));
}

// True when the set changed.
bool mark_near(Order& order, const Points& points, const Grid& grid) {
    const bool sized = order.is_near.size() == points.size();
    if (grid.near.empty() && sized && order.near.empty()) return false;
    std::uint8_t changed = sized ? 0 : 1;
    order.is_near.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double x = points.x[p], y = points.y[p];
        std::uint8_t inside = 0;
        for (const Rectangle& box : grid.near)
            inside |= static_cast<std::uint8_t>((x > box.x0) & (x < box.x1) & (y > box.y0) & (y < box.y1));
        changed |= order.is_near[p] ^ inside;
        order.is_near[p] = inside;
    }
    return changed != 0;
}

void count_bands(Order& order, const std::vector<std::int32_t>& band, int bands) {
    order.first.assign(static_cast<std::size_t>(bands) + 1, 0);
    for (const auto b : band)
        if (b >= 0) ++order.first[static_cast<std::size_t>(b) + 1];
    std::partial_sum(order.first.begin(), order.first.end(), order.first.begin());
}

// Counting sort: stable, so ids ascend within a band.
void sort(Order& order, const Points& points, const GridShape& shape) {
    std::vector<std::int32_t> band(points.size(), -1);
    order.near.clear();
    for (std::size_t p = 0; p < points.size(); ++p)
        if (order.is_near[p])
            order.near.push_back(static_cast<std::int32_t>(p));
        else
            band[p] = band_of(base_row(shape, points.half, points.y[p]));
    count_bands(order, band, shape.rows() / band_rows + 1);
    std::vector<std::int32_t> next(order.first.begin(), order.first.end() - 1);
    order.ids.resize(static_cast<std::size_t>(order.first.back()));
    for (std::size_t p = 0; p < points.size(); ++p)
        if (band[p] >= 0)
            order.ids[static_cast<std::size_t>(next[static_cast<std::size_t>(band[p])]++)] =
                static_cast<std::int32_t>(p);
}

}  // namespace

void refresh(Order& order, const Points& points, const Grid& grid) {
    SG_EXPECT(points.half > 0 && points.half <= 0.5 * grid.shape.cell * (1 + 1e-12));
    const bool near_changed = mark_near(order, points, grid);
    if (!near_changed && !order.stale) return;
    require_inside(points, grid.shape);
    sort(order, points, grid.shape);
    order.stale = false;
    SG_ENSURE(order.ids.size() + order.near.size() == points.size());
}

}  // namespace sandgraph::mpm
