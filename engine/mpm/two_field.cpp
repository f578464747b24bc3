#include "mpm/two_field.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "mpm/advance_point.hpp"
#include "mpm/stencil.hpp"

namespace sandgraph::mpm {
namespace {

// First and last node around [low, high], clipped to the grid. If a ghost node is in use then so is
// its mirror image, which boundaries read.
void span_nodes(double low, double high, double cell, int cells, int& first, int& last) {
    first = std::max(-1, static_cast<int>(std::floor(low / cell)));
    last = std::min(cells + 1, static_cast<int>(std::ceil(high / cell)));
    if (first <= -1) last = std::max(last, 1);
    if (last >= cells + 1) first = std::min(first, cells - 1);
}

NodeBox nodes_around(const Enrichment& enrichment, const GridShape& shape) {
    NodeBox box;
    const Rectangle r = inflated(enrichment.surroundings(shape.cell, 0.5 * shape.cell), 1.5 * shape.cell);
    span_nodes(r.x0 - shape.x0, r.x1 - shape.x0, shape.cell, shape.nx, box.i0, box.i1);
    span_nodes(r.y0 - shape.y0, r.y1 - shape.y0, shape.cell, shape.ny, box.j0, box.j1);
    return box;
}

NodeBox hull(const NodeBox& a, const NodeBox& b) {
    if (a.empty()) return b;
    return {std::min(a.i0, b.i0), std::min(a.j0, b.j0), std::max(a.i1, b.i1), std::max(a.j1, b.j1)};
}

Stencil stencil_of(std::size_t p, const Points& points, const Grid& grid) {
    const GridShape& s = grid.shape;
    const double x = points.x[p], y = points.y[p], half = points.half;
    return stencil(grid, average(x - half - s.x0, x + half - s.x0, s.cell),
                   average(y - half - s.y0, y + half - s.y0, s.cell), x, y);
}

void scatter_point(std::size_t p, const Points& points, std::span<const Stress> stress, Grid& grid) {
    const double m = points.mass[p], V = points.volume[p];
    const Stress& s = stress[p];
    const Stencil r = stencil_of(p, points, grid);
    for_each_node(grid, r, [&](unsigned field, std::size_t index, std::size_t i, std::size_t j) {
        const double S = r.x.S[i] * r.y.S[j], dx = r.x.dS[i] * r.y.S[j], dy = r.x.S[i] * r.y.dS[j];
        Node& node = grid.fields[field].nodes[index];
        node.mass += S * m;
        node.px += S * m * points.vx[p];
        node.py += S * m * points.vy[p];
        node.mx += S * m * points.x[p], node.my += S * m * points.y[p], node.own += S * m;
        node.fx -= V * (s.xx * dx + s.xy * dy);
        node.fy -= V * (s.xy * dx + s.yy * dy);
    });
}

Reading read_point(std::size_t p, const Points& points, const Grid& grid) {
    Reading sum;
    const Stencil r = stencil_of(p, points, grid);
    for_each_node(grid, r, [&](unsigned field, std::size_t index, std::size_t i, std::size_t j) {
        const double S = r.x.S[i] * r.y.S[j], dx = r.x.dS[i] * r.y.S[j], dy = r.x.S[i] * r.y.dS[j];
        const Motion& m = grid.fields[field].motion[index];
        sum.vx += S * m.vx, sum.vy += S * m.vy, sum.ax += S * m.ax, sum.ay += S * m.ay;
        sum.xx += dx * m.vx, sum.xy += dy * m.vx, sum.yx += dx * m.vy, sum.yy += dy * m.vy;
    });
    return sum;
}

}  // namespace

void set_bodies(Grid& grid, std::span<const Enrichment> bodies, double half) {
    SG_EXPECT(half > 0);
    Field& second = grid.fields[1];
    grid.cuts.clear(), grid.near.clear();
    second.box = {};
    for (const Enrichment& body : bodies) {
        if (!body.active) continue;
        grid.near.push_back(body.surroundings(grid.shape.cell, half));
        if (body.half_thickness >= grid.shape.cell * (1 - 1e-9)) continue;
        grid.cuts.push_back(body);
        grid.cuts.back().margin = grid.shape.cell + half;
        second.box = hull(second.box, nodes_around(body, grid.shape));
    }
    if (second.box.empty() || !second.nodes.empty()) return;
    second.nodes.resize(grid.shape.size());
    second.motion.resize(grid.shape.size());
}

void scatter_enriched(std::span<const std::int32_t> ids, const Points& points, std::span<const Stress> stress,
                      Grid& grid) {
    SG_EXPECT(all_below(ids, points.size()));
    for (const auto p : ids) scatter_point(static_cast<std::size_t>(p), points, stress, grid);
}

void gather_enriched(std::span<const std::int32_t> ids, const Grid& grid, const Advance& advance,
                     Points& points) {
    SG_EXPECT(all_below(ids, points.size()));
    for (const auto p : ids) {
        const auto id = static_cast<std::size_t>(p);
        advance_point(read_point(id, points, grid), advance, id, points);
    }
}

}  // namespace sandgraph::mpm
