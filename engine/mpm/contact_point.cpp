#include "mpm/contact_point.hpp"

#include <algorithm>
#include <limits>

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

// Of the rest pressure at height y: docs/how_it_works.md (eq. 15).
double rest_penetration(Face face, const RigidPlate& plate, double y) {
    const RestPressure& r = plate.rest;
    const double depth = plate.y - y;
    const double pressure = horizontal(face) ? r.vertical + depth * r.vertical_gradient
                                             : r.horizontal + depth * r.horizontal_gradient;
    return std::max(pressure, 0.0) / plate.stiffness;  // none above the surface
}

// Depth of the point's domain past the bare face, plus `out`.
double penetration(Face face, const Rectangle& body, const Rectangle& domain, double out) {
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

// Leaves the nodes from low to high [m from the grid's origin] to carry all; whether others did.
bool trim(Weights& w, double low, double high, double cell) {
    double kept = 0;
    bool trimmed = false;
    for (int i = 0; i < 3; ++i) {
        const double at = (w.base + i) * cell;
        double& S = w.S[static_cast<std::size_t>(i)];
        if (S != 0 && (at < low - shortest * cell || at > high + shortest * cell)) S = 0, trimmed = true;
        kept += S;
    }
    if (kept == 0) return false;
    for (double& S : w.S) S /= kept;
    return trimmed;
}

Stencil own_stencil(const Rectangle& domain, const Grid& grid, const Vec2& centre) {
    const GridShape& s = grid.shape;
    return stencil(grid, average(domain.x0 - s.x0, domain.x1 - s.x0, s.cell),
                   average(domain.y0 - s.y0, domain.y1 - s.y0, s.cell), centre.x(), centre.y());
}

void set_stencils(ContactPoint& c, const Rectangle& body, const Rectangle& domain, const Grid& grid,
                  const Vec2& centre, bool trimmed) {
    const GridShape& s = grid.shape;
    const bool flat = horizontal(c.face);
    const Interval ox = overlap(domain.x0, domain.x1, body.x0, body.x1);
    const Interval oy = overlap(domain.y0, domain.y1, body.y0, body.y1);
    const double edge_x = c.face == Face::left ? domain.x1 : domain.x0;
    const double edge_y = c.face == Face::bottom ? domain.y1 : domain.y0;
    Weights x = flat ? average(ox.low - s.x0, ox.high - s.x0, s.cell) : at(edge_x - s.x0, s.cell);
    Weights y = flat ? at(edge_y - s.y0, s.cell) : average(oy.low - s.y0, oy.high - s.y0, s.cell);
    const Weights all_x = flat ? average(domain.x0 - s.x0, domain.x1 - s.x0, s.cell) : x;
    const Weights all_y = flat ? y : average(domain.y0 - s.y0, domain.y1 - s.y0, s.cell);
    c.whole = stencil(grid, all_x, all_y, centre.x(), centre.y());
    c.at_end = trimmed && (flat ? trim(x, body.x0 - s.x0, body.x1 - s.x0, s.cell)
                                : trim(y, body.y0 - s.y0, body.y1 - s.y0, s.cell));
    c.stencil = stencil(grid, x, y, centre.x(), centre.y());
    if (c.at_end) c.own = own_stencil(domain, grid, centre);
}

}  // namespace

Vec2 normal(Face face) {
    SG_EXPECT(face != Face::none);
    if (horizontal(face)) return {0, face == Face::top ? 1 : -1};
    return {face == Face::right ? 1 : -1, 0};
}

namespace {

// Normal and penetration of the square domain as of a circle as wide; the length is the part of the edge that
// a point of a staircase along it stands for.
ContactPoint touch_circle(const RigidPlate& plate, const Points& points, std::int32_t id, const Grid& grid) {
    const auto p = static_cast<std::size_t>(id);
    const Vec2 at(points.x[p], points.y[p]);
    const Vec2 n = (at - Vec2(plate.x, plate.y)).normalized();
    const double y = at.y() - points.half * n.y(), nx2 = n.x() * n.x();
    const double rest =
        (1 - nx2) * rest_penetration(Face::top, plate, y) + nx2 * rest_penetration(Face::right, plate, y);
    ContactPoint c{.point = id, .face = Face::round, .normal = n, .rest = rest};
    c.penetration = points.half - plate.distance(at.x(), at.y()) + rest;
    c.length = 2 * points.half / n.cwiseAbs().maxCoeff() * share(points, p);
    const Vec2 edge = at - points.half * n;
    const GridShape& s = grid.shape;
    c.stencil =
        stencil(grid, mpm::at(edge.x() - s.x0, s.cell), mpm::at(edge.y() - s.y0, s.cell), at.x(), at.y());
    return c;
}

}  // namespace

double bedding(const RigidPlate& plate, const Points& points, std::size_t p) {
    const double step = 2 * points.half, x = points.x[p], y = points.y[p];
    const bool touches = plate.round && (plate.distance(x - step, y) < 0 || plate.distance(x + step, y) < 0 ||
                                         plate.distance(x, y - step) < 0 || plate.distance(x, y + step) < 0);
    return touches ? points.half - plate.distance(x, y) : std::numeric_limits<double>::quiet_NaN();
}

ContactPoint find_contact_point(const RigidPlate& plate, const Points& points, std::int32_t id,
                                const Grid& grid) {
    SG_EXPECT(id >= 0 && static_cast<std::size_t>(id) < points.size());
    if (plate.round) return touch_circle(plate, points, id, grid);
    const auto p = static_cast<std::size_t>(id);
    const double x = points.x[p], y = points.y[p], half = points.half;
    const std::int32_t cut = points.cut[p];
    const Rectangle body = plate.rectangle(),
                    domain = {cut < 0 ? x : x - half, y - half, cut > 0 ? x : x + half, y + half};
    const Interval ox = overlap(domain.x0, domain.x1, body.x0, body.x1);
    const Interval oy = overlap(domain.y0, domain.y1, body.y0, body.y1);
    ContactPoint best{.point = id};
    for (const Face face : {Face::top, Face::bottom, Face::left, Face::right}) {
        const double length = horizontal(face) ? ox.length() : oy.length();
        const double rest = rest_penetration(face, plate, face_height(face, body, oy));
        const double depth = penetration(face, body, domain, rest);
        if (depth <= 0) return {.point = id};
        if (length <= shortest * half || (best.face != Face::none && depth >= best.penetration)) continue;
        best = {.point = id,
                .face = face,
                .penetration = depth,
                .length = length * (cut != 0 ? 1 : share(points, p)),
                .rest = rest};
    }
    if (best.face == Face::none) return best;
    best.normal = normal(best.face);
    set_stencils(best, body, domain, grid, {x, y}, plate.trimmed);
    SG_ENSURE(best.face == Face::none || (best.penetration > 0 && best.length > 0));
    return best;
}

}  // namespace sandgraph::mpm
