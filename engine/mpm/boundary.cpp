#include "mpm/boundary.hpp"

#include "base/contracts.hpp"
#include "mpm/stencil.hpp"

namespace sandgraph::mpm {
namespace {

// Lines of nodes along one side of the grid, as far as the field is in use: images outside of it, those on
// the side itself (none where it lies between nodes), and those inside that the images mirror.
struct Edge {
    std::size_t image, plane, inner;  // indices of their first nodes
    std::size_t step = 0;
    int count = 0;
    bool normal_x = false, between = false;
};

// The side of column `plane` of nodes, `outward` -1 or 1.
Edge vertical(const Field& field, const GridShape& s, int plane, int outward, bool between) {
    const NodeBox& b = field.box;
    const int image = between ? plane : plane + outward;
    const bool used = !b.empty() && b.i0 <= image && image <= b.i1;
    return {s.index(image, b.j0),
            s.index(plane, b.j0),
            s.index(plane - outward, b.j0),
            static_cast<std::size_t>(s.stride()),
            used ? b.j1 - b.j0 + 1 : 0,
            true,
            between};
}

Edge horizontal(const Field& field, const GridShape& s, int plane, int outward, bool between) {
    const NodeBox& b = field.box;
    const int image = between ? plane : plane + outward;
    const bool used = !b.empty() && b.j0 <= image && image <= b.j1;
    return {s.index(b.i0, image),
            s.index(b.i0, plane),
            s.index(b.i0, plane - outward),
            1,
            used ? b.i1 - b.i0 + 1 : 0,
            false,
            between};
}

// f(edge) for the sides of that kind: left, right, bottom, top.
template <class F>
void for_sides(const Field& field, const GridShape& s, const Boundaries& b, Side kind, F f) {
    if (b.left == kind) f(vertical(field, s, 0, -1, b.between_x));
    if (b.right == kind) f(vertical(field, s, s.nx, 1, b.between_x));
    if (b.bottom == kind) f(horizontal(field, s, 0, -1, b.between_y));
    if (b.top == kind) f(horizontal(field, s, s.ny, 1, b.between_y));
}

// f(offset) for the nodes along an edge.
template <class F>
void along(const Edge& e, F f) {
    for (std::size_t k = 0, at = 0; k < static_cast<std::size_t>(e.count); ++k, at += e.step) f(at);
}

// An image moves as its original times (sx, sy); what points gave to it the original takes over likewise.
struct Signs {
    double x, y;
};
Signs mirrored(const Edge& e) { return e.normal_x ? Signs{-1, 1} : Signs{1, -1}; }

void take_image(Field& field, const Edge& e, Signs s, std::size_t at) {
    const Node image = field.nodes[e.image + at];
    Node& inner = field.nodes[e.inner + at];
    inner.mass += image.mass;
    inner.px += s.x * image.px, inner.py += s.y * image.py;
    inner.fx += s.x * image.fx, inner.fy += s.y * image.fy;
    field.nodes[e.image + at] = Node{};
}

void move_image(Field& field, const Edge& e, Signs s, std::size_t at) {
    const Motion m = field.motion[e.inner + at];
    field.motion[e.image + at] = {s.x * m.vx, s.y * m.vy, s.x * m.ax, s.y * m.ay};
}

void fold_edge(Field& field, const Edge& e) {
    along(e, [&](std::size_t at) {
        take_image(field, e, mirrored(e), at);
        if (e.between) return;
        Node& plane = field.nodes[e.plane + at];
        (e.normal_x ? plane.px : plane.py) = 0;
        (e.normal_x ? plane.fx : plane.fy) = 0;
    });
}

void mirror_edge(Field& field, const Edge& e) {
    along(e, [&](std::size_t at) {
        move_image(field, e, mirrored(e), at);
        if (e.between) return;
        Motion& plane = field.motion[e.plane + at];
        (e.normal_x ? plane.vx : plane.vy) = 0;
        (e.normal_x ? plane.ax : plane.ay) = 0;
    });
}

void hold(Motion& m, double dt) { m = {0, 0, m.ax - m.vx / dt, m.ay - m.vy / dt}; }

// Between nodes: at rest midway to an image of opposite motion.
void fix_edge(Field& field, const Edge& e, double dt) {
    along(e, [&](std::size_t at) {
        if (e.between) return move_image(field, e, {-1, -1}, at);
        hold(field.motion[e.image + at], dt);
        hold(field.motion[e.plane + at], dt);
    });
}

void fold_fixed(Field& field, const Edge& e) {
    if (!e.between) return;
    along(e, [&](std::size_t at) { take_image(field, e, {-1, -1}, at); });
}

}  // namespace

void fold(Field& field, const GridShape& shape, const Boundaries& boundaries) {
    SG_EXPECT(field.box.empty() || field.nodes.size() == shape.size());
    for_sides(field, shape, boundaries, Side::mirror, [&](const Edge& e) { fold_edge(field, e); });
    for_sides(field, shape, boundaries, Side::fixed, [&](const Edge& e) { fold_fixed(field, e); });
}

void constrain(Field& field, const GridShape& shape, const Boundaries& boundaries, double dt) {
    SG_EXPECT(dt > 0);
    SG_EXPECT(field.box.empty() || field.motion.size() == shape.size());
    for_sides(field, shape, boundaries, Side::fixed, [&](const Edge& e) { fix_edge(field, e, dt); });
    for_sides(field, shape, boundaries, Side::mirror, [&](const Edge& e) { mirror_edge(field, e); });
}

void add_surcharge(double q, const Points& points, Grid& grid) {  // docs/how_it_works.md (eq. 4)
    SG_EXPECT(all_below(points.surface, points.size()) &&
              points.bare.size() == points.surface.size());  // a pull where q < 0
    const GridShape& s = grid.shape;
    const double half = points.half;
    for (std::size_t k = 0; k < points.surface.size(); ++k) {
        const auto p = static_cast<std::size_t>(points.surface[k]);
        const double x = points.x[p] - s.x0, y = points.y[p] - s.y0;
        const Stencil top = stencil(grid, average(x - half, x + half, s.cell), at(y + half, s.cell),
                                    points.x[p], points.y[p]);
        spread(grid, top, 0, -q * 2 * half * share(points, p) * points.bare[k]);
    }
}

}  // namespace sandgraph::mpm
