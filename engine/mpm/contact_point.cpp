#include "mpm/contact_point.hpp"

#include <algorithm>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

// Shorter overlaps are round-off of two edges that meet, in shares of a point's half side.
constexpr double shortest = 1e-9;

struct Interval {
    double low, high;
    double length() const { return high - low; }
};

Interval overlap(double a0, double a1, double b0, double b1) { return {std::max(a0, b0), std::min(a1, b1)}; }

// Depth past the bare face plus the rest pressure's penetration at height y: docs/how_it_works.md (eq. 15).
double penetration(Face face, const RigidPlate& plate, const Rectangle& body, const Rectangle& domain,
                   double y) {
    const RestPressure& r = plate.rest;
    const double depth = plate.y - y;
    const double rest = horizontal(face) ? r.vertical + depth * r.vertical_gradient
                                         : r.horizontal + depth * r.horizontal_gradient;
    const double out = rest / plate.stiffness;
    switch (face) {
        case Face::top:
            return body.y1 - domain.y0 + out;
        case Face::bottom:
            return domain.y1 - body.y0 + out;
        case Face::left:
            return domain.x1 - body.x0 + out;
        case Face::right:
            return body.x1 - domain.x0 + out;
        default:
            return 0;
    }
}

double face_height(Face face, const Rectangle& body, const Interval& y) {
    if (face == Face::top) return body.y1;
    if (face == Face::bottom) return body.y0;
    return 0.5 * (y.low + y.high);
}

Stencil stencil_of(Face face, const Rectangle& domain, const Interval& ox, const Interval& oy,
                   const Grid& grid, const Vec2& centre) {
    const GridShape& s = grid.shape;
    const double edge_x = face == Face::left ? domain.x1 : domain.x0;
    const double edge_y = face == Face::bottom ? domain.y1 : domain.y0;
    const bool flat = horizontal(face);
    const Weights x = flat ? average(ox.low - s.x0, ox.high - s.x0, s.cell) : at(edge_x - s.x0, s.cell);
    const Weights y = flat ? at(edge_y - s.y0, s.cell) : average(oy.low - s.y0, oy.high - s.y0, s.cell);
    return stencil(grid, x, y, centre.x(), centre.y());
}

}  // namespace

Vec2 normal(Face face) {
    SG_EXPECT(face != Face::none);
    if (horizontal(face)) return {0, face == Face::top ? 1 : -1};
    return {face == Face::right ? 1 : -1, 0};
}

ContactPoint find_contact_point(const RigidPlate& plate, const Points& points, std::int32_t id,
                                const Grid& grid) {
    SG_EXPECT(id >= 0 && static_cast<std::size_t>(id) < points.size());
    const auto p = static_cast<std::size_t>(id);
    const double x = points.x[p], y = points.y[p], half = points.half;
    const Rectangle body = plate.rectangle(), domain = {x - half, y - half, x + half, y + half};
    const Interval ox = overlap(domain.x0, domain.x1, body.x0, body.x1);
    const Interval oy = overlap(domain.y0, domain.y1, body.y0, body.y1);
    ContactPoint best{id, Face::none, 0, 0, {}};
    for (const Face face : {Face::top, Face::bottom, Face::left, Face::right}) {
        const double length = horizontal(face) ? ox.length() : oy.length();
        const double depth = penetration(face, plate, body, domain, face_height(face, body, oy));
        if (depth <= 0) return {id, Face::none, 0, 0, {}};
        if (length <= shortest * half || (best.face != Face::none && depth >= best.penetration)) continue;
        best = {id, face, depth, length, {}};
    }
    if (best.face != Face::none) best.stencil = stencil_of(best.face, domain, ox, oy, grid, {x, y});
    SG_ENSURE(best.face == Face::none || (best.penetration > 0 && best.length > 0));
    return best;
}

}  // namespace sandgraph::mpm
