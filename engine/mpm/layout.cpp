#include "mpm/layout.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

bool empty_at(const Layout& layout, double x, double y) {
    if (layout.inside && !layout.inside(x, y)) return true;
    return std::any_of(layout.cavities.begin(), layout.cavities.end(),
                       [&](const Rectangle& r) { return r.contains(x, y); });
}

void add_row(const Layout& layout, Points& points, double y, std::int32_t row) {
    const Rectangle& g = layout.ground;
    const double spacing = 2 * points.half;
    const auto columns = std::lround((g.x1 - g.x0) / spacing);
    for (long k = 0; k < columns; ++k) {
        const double x = g.x0 + (static_cast<double>(k) + 0.5) * spacing;
        if (empty_at(layout, x, y)) continue;
        if (row == 0) points.surface.push_back(static_cast<std::int32_t>(points.x.size()));
        points.x.push_back(x);
        points.y.push_back(y);
        points.row.push_back(row);
    }
}

}  // namespace

Points lay_out(const Layout& layout) {
    SG_EXPECT(layout.cell > 0 && layout.points_per_cell > 0 && layout.density > 0);
    SG_EXPECT(layout.ground.x1 > layout.ground.x0 && layout.ground.y1 > layout.ground.y0);
    Points points;
    points.half = 0.5 * layout.cell / std::sqrt(static_cast<double>(layout.points_per_cell));
    const double spacing = 2 * points.half;
    const auto rows = std::lround((layout.ground.y1 - layout.ground.y0) / spacing);
    for (long k = 0; k < rows; ++k) {
        const double y = layout.ground.y0 + (static_cast<double>(k) + 0.5) * spacing;
        add_row(layout, points, y, static_cast<std::int32_t>(rows - 1 - k));
    }
    resize(points, points.x.size());
    std::fill(points.volume0.begin(), points.volume0.end(), spacing * spacing);
    points.volume = points.volume0;
    std::fill(points.mass.begin(), points.mass.end(), layout.density * spacing * spacing);
    SG_ENSURE(points.row.size() == points.size() && all_below(points.surface, points.size()));
    return points;
}

}  // namespace sandgraph::mpm
