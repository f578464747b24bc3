#include "mpm/layout.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

bool in_cavity(const Layout& layout, double x, double y) {
    return std::any_of(layout.cavities.begin(), layout.cavities.end(),
                       [&](const Rectangle& r) { return r.contains(x, y); });
}

// Whether the halves of a point's domain left and right of its centre lie in bodies. Of a point on a side of
// the ground both are those of its half inside.
struct Halves {
    bool left, right;
};

Halves halves_in_cavities(const Layout& layout, double x, double y, double half) {
    const Rectangle& g = layout.ground;
    const auto inside = [&](double at) { return std::clamp(at, g.x0 + 0.25 * half, g.x1 - 0.25 * half); };
    return {in_cavity(layout, inside(x - 0.5 * half), y), in_cavity(layout, inside(x + 0.5 * half), y)};
}

bool empty_at(const Layout& layout, double x, double y, double half) {
    if (layout.inside && !layout.inside(x, y)) return true;
    const Halves in = halves_in_cavities(layout, x, y, half);
    return in.left && in.right;
}

// Which half of the domain a body's end takes away: Points::cut.
std::int32_t cut_at(const Layout& layout, double x, double y, double half) {
    const Halves in = halves_in_cavities(layout, x, y, half);
    return in.right - in.left;
}

// Share of a surface point's edge on which no body stands, to take the place of the surcharge.
double bare_at(const Layout& layout, double x, double above, double half) {
    const Halves covered = halves_in_cavities(layout, x, above, half);
    return 1 - 0.5 * covered.left - 0.5 * covered.right;
}

void add_row(const Layout& layout, Points& points, double y, std::int32_t row) {
    const Rectangle& g = layout.ground;
    const double spacing = 2 * points.half;
    const long columns = std::lround((g.x1 - g.x0) / spacing) + (layout.columns_on_sides ? 1 : 0);
    const double first = layout.columns_on_sides ? 0 : 0.5;
    for (long k = 0; k < columns; ++k) {
        const double x = g.x0 + (static_cast<double>(k) + first) * spacing;
        if (empty_at(layout, x, y, points.half)) continue;
        const double bare = row == 0 ? bare_at(layout, x, y + 2 * points.half, points.half) : 0;
        if (bare > 0) {
            points.surface.push_back(static_cast<std::int32_t>(points.x.size()));
            points.bare.push_back(bare);
        }
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
        points.cut[p] = cut_at(layout, x, points.y[p], points.half);
        points.volume0[p] = (on_side || points.cut[p] != 0 ? 0.5 : 1) * spacing * spacing;
        points.mass[p] = layout.density * points.volume0[p];
    }
    points.volume = points.volume0;
    SG_ENSURE(points.row.size() == points.size() && all_below(points.surface, points.size()));
    return points;
}

}  // namespace sandgraph::mpm
