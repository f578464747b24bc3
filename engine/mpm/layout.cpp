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

// Whether a body stands on the surface there: it takes the place of the surcharge.
bool covered(const Layout& layout, double x, double above) {
    return std::any_of(layout.cavities.begin(), layout.cavities.end(),
                       [&](const Rectangle& r) { return r.contains(x, above); });
}

void add_row(const Layout& layout, Points& points, double y, std::int32_t row) {
    const Rectangle& g = layout.ground;
    const double spacing = 2 * points.half;
    const long columns = std::lround((g.x1 - g.x0) / spacing) + (layout.columns_on_sides ? 1 : 0);
    const double first = layout.columns_on_sides ? 0 : 0.5;
    for (long k = 0; k < columns; ++k) {
        const double x = g.x0 + (static_cast<double>(k) + first) * spacing;
        const double inside = std::clamp(x, g.x0 + 0.5 * points.half, g.x1 - 0.5 * points.half);
        if (empty_at(layout, inside, y)) continue;
        if (row == 0 && !covered(layout, inside, y + 2 * points.half))
            points.surface.push_back(static_cast<std::int32_t>(points.x.size()));
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
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double x = points.x[p];
        const bool on_side = layout.columns_on_sides && (x - layout.ground.x0 < 0.5 * points.half ||
                                                         layout.ground.x1 - x < 0.5 * points.half);
        points.volume0[p] = (on_side ? 0.5 : 1) * spacing * spacing;
        points.mass[p] = layout.density * points.volume0[p];
    }
    points.volume = points.volume0;
    SG_ENSURE(points.row.size() == points.size() && all_below(points.surface, points.size()));
    return points;
}

}  // namespace sandgraph::mpm
