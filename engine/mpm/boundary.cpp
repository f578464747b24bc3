#include "mpm/boundary.hpp"

#include "base/contracts.hpp"
#include "mpm/stencil.hpp"

namespace sandgraph::mpm {
namespace {

// Three lines of nodes along one side of the grid, as far as the field is in use.
struct Edge {
    std::size_t ghost, plane, inner;  // indices of their first nodes
    std::size_t step = 0;
    int count = 0;
    bool normal_x = false;
};

Edge vertical(const Field& field, const GridShape& s, int plane, int outward) {
    const NodeBox& b = field.box;
    const bool used = !b.empty() && b.i0 <= plane + outward && plane + outward <= b.i1;
    return {s.index(plane + outward, b.j0),       s.index(plane, b.j0),       s.index(plane - outward, b.j0),
            static_cast<std::size_t>(s.stride()), used ? b.j1 - b.j0 + 1 : 0, true};
}

Edge horizontal(const Field& field, const GridShape& s, int plane, int outward) {
    const NodeBox& b = field.box;
    const bool used = !b.empty() && b.j0 <= plane + outward && plane + outward <= b.j1;
    return {s.index(b.i0, plane + outward), s.index(b.i0, plane),
            s.index(b.i0, plane - outward), 1,
            used ? b.i1 - b.i0 + 1 : 0,     false};
}

// f(edge) for the sides of that kind: left, right, bottom, top.
template <class F>
void for_sides(const Field& field, const GridShape& s, const Boundaries& b, Side kind, F f) {
    if (b.left == kind) f(vertical(field, s, 0, -1));
    if (b.right == kind) f(vertical(field, s, s.nx, 1));
    if (b.bottom == kind) f(horizontal(field, s, 0, -1));
    if (b.top == kind) f(horizontal(field, s, s.ny, 1));
}

void fold_edge(Field& field, const Edge& e) {
    const double sx = e.normal_x ? -1 : 1, sy = -sx;
    for (std::size_t k = 0, at = 0; k < static_cast<std::size_t>(e.count); ++k, at += e.step) {
        const Node ghost = field.nodes[e.ghost + at];
        Node& inner = field.nodes[e.inner + at];
        Node& plane = field.nodes[e.plane + at];
        inner.mass += ghost.mass;
        inner.px += sx * ghost.px, inner.py += sy * ghost.py;
        inner.fx += sx * ghost.fx, inner.fy += sy * ghost.fy;
        (e.normal_x ? plane.px : plane.py) = 0;
        (e.normal_x ? plane.fx : plane.fy) = 0;
        field.nodes[e.ghost + at] = Node{};
    }
}

void mirror_edge(Field& field, const Edge& e) {
    const double sx = e.normal_x ? -1 : 1, sy = -sx;
    for (std::size_t k = 0, at = 0; k < static_cast<std::size_t>(e.count); ++k, at += e.step) {
        const Motion inner = field.motion[e.inner + at];
        Motion& plane = field.motion[e.plane + at];
        (e.normal_x ? plane.vx : plane.vy) = 0;
        (e.normal_x ? plane.ax : plane.ay) = 0;
        field.motion[e.ghost + at] = {sx * inner.vx, sy * inner.vy, sx * inner.ax, sy * inner.ay};
    }
}

void hold(Motion& m, double dt) { m = {0, 0, m.ax - m.vx / dt, m.ay - m.vy / dt}; }

void fix_edge(Field& field, const Edge& e, double dt) {
    for (std::size_t k = 0, at = 0; k < static_cast<std::size_t>(e.count); ++k, at += e.step) {
        hold(field.motion[e.ghost + at], dt);
        hold(field.motion[e.plane + at], dt);
    }
}

}  // namespace

void fold(Field& field, const GridShape& shape, const Boundaries& boundaries) {
    SG_EXPECT(field.box.empty() || field.nodes.size() == shape.size());
    for_sides(field, shape, boundaries, Side::mirror, [&](const Edge& e) { fold_edge(field, e); });
}

void constrain(Field& field, const GridShape& shape, const Boundaries& boundaries, double dt) {
    SG_EXPECT(dt > 0);
    SG_EXPECT(field.box.empty() || field.motion.size() == shape.size());
    for_sides(field, shape, boundaries, Side::fixed, [&](const Edge& e) { fix_edge(field, e, dt); });
    for_sides(field, shape, boundaries, Side::mirror, [&](const Edge& e) { mirror_edge(field, e); });
}

void add_surcharge(double q, const Points& points, Grid& grid) {  // docs/how_it_works.md (eq. 4)
    SG_EXPECT(q >= 0 && all_below(points.surface, points.size()));
    const GridShape& s = grid.shape;
    const double half = points.half;
    for (const auto id : points.surface) {
        const auto p = static_cast<std::size_t>(id);
        const double x = points.x[p] - s.x0, y = points.y[p] - s.y0;
        const Stencil top = stencil(grid, average(x - half, x + half, s.cell), at(y + half, s.cell),
                                    points.x[p], points.y[p]);
        spread(grid, top, 0, -q * 2 * half);
    }
}

}  // namespace sandgraph::mpm
