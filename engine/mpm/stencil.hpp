#pragma once
#include "mpm/grid.hpp"
#include "mpm/shape.hpp"

namespace sandgraph::mpm {

// The 3 x 3 nodes that a point (or a line of force on its edge) acts on, and in which field of each it takes
// part.
struct Stencil {
    Weights x, y;
    unsigned across = 0;  // bit 3 j + i: the node is enriched, the point belongs to its second field
};

inline Stencil stencil(const Grid& grid, const Weights& x, const Weights& y, double point_x, double point_y) {
    Stencil r{x, y, 0};
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            if (grid.enriches(point_x, point_y, grid.shape.x(x.base + i), grid.shape.y(y.base + j)))
                r.across |= 1u << (3 * j + i);
    return r;
}

// Calls f(field, node, i, j) for the nine nodes, always in the same order.
template <class F>
void for_each_node(const Grid& grid, const Stencil& r, F f) {
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            f((r.across >> (3 * j + i)) & 1u, grid.shape.index(r.x.base + i, r.y.base + j),
              static_cast<std::size_t>(i), static_cast<std::size_t>(j));
}

// A force [N/m] spread with the weights S.
inline void spread(Grid& grid, const Stencil& r, double fx, double fy) {
    for_each_node(grid, r, [&](unsigned field, std::size_t node, std::size_t i, std::size_t j) {
        const double S = r.x.S[i] * r.y.S[j];
        if (S == 0) return;  // also keeps the unused third node of a hat off the end of the grid
        grid.fields[field].nodes[node].fx += S * fx;
        grid.fields[field].nodes[node].fy += S * fy;
    });
}

// Grid velocity [m/s] averaged with the weights S, after update_grid.
inline Vec2 velocity(const Grid& grid, const Stencil& r) {
    Vec2 v = Vec2::Zero();
    for_each_node(grid, r, [&](unsigned field, std::size_t node, std::size_t i, std::size_t j) {
        const double S = r.x.S[i] * r.y.S[j];
        if (S == 0) return;
        const Motion& m = grid.fields[field].motion[node];
        v += S * Vec2(m.vx, m.vy);
    });
    return v;
}

}  // namespace sandgraph::mpm
