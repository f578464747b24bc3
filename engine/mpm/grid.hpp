#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/tensor.hpp"
#include "mpm/enrichment.hpp"

namespace sandgraph::mpm {

// Square cells of `cell` [m] over [x0, x0 + nx cell] x [y0, y0 + ny cell], plus one ghost layer of nodes
// around. Node (i, j) with i in [-1, nx + 1], j in [-1, ny + 1] sits at (x0 + i cell, y0 + j cell).
struct GridShape {
    double x0 = 0, y0 = 0, cell = 0.1;
    int nx = 0, ny = 0;

    int stride() const { return nx + 3; }
    int rows() const { return ny + 3; }
    std::size_t size() const { return static_cast<std::size_t>(stride()) * static_cast<std::size_t>(rows()); }
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(stride()) +
               static_cast<std::size_t>(i + 1);
    }
    double x(int i) const { return x0 + i * cell; }
    double y(int j) const { return y0 + j * cell; }
    // A NaN is outside.
    bool contains(double px, double py) const {
        return px >= x0 && px <= x0 + nx * cell && py >= y0 && py <= y0 + ny * cell;
    }
};

// Sums over the points whose stencil holds the node; one cache line, so that a point adds to it with one or
// two vector FMAs.
struct alignas(64) Node {
    double mass = 0;        // [kg/m], gravity mass: mass scaling enters at the grid update only
    double px = 0, py = 0;  // momentum [kg/s]
    double fx = 0, fy = 0;  // internal + external force without gravity [N/m]
    // Of the points themselves, mirror images apart: mass times position and mass; tells where a light node's
    // material is.
    double mx = 0, my = 0, own = 0;
};

// What the points read back: velocity after the update [m/s] and acceleration of the step [m/s2].
struct alignas(32) Motion {
    double vx = 0, vy = 0, ax = 0, ay = 0;
};

// One single-valued velocity field. The second field of a grid lives on the nodes around the rigid plate
// only.
struct Field {
    std::vector<Node> nodes;
    std::vector<Motion> motion;
    NodeBox box;  // nodes in use
};

inline constexpr NodeBox whole(const GridShape& s) { return {-1, -1, s.nx + 1, s.ny + 1}; }

struct Grid {
    explicit Grid(const GridShape& grid_shape);

    // Whether a point there takes part in the second field of the node (enrichment.hpp).
    bool enriches(double point_x, double point_y, double node_x, double node_y) const {
        for (const Enrichment& cut : cuts)
            if (cut.enriches(point_x, point_y, node_x, node_y)) return true;
        return false;
    }
    bool parts(double point_x, double point_y, double at_x, double at_y) const {
        for (const Enrichment& cut : cuts)
            if (cut.parts(point_x, point_y, at_x, at_y)) return true;
        return false;
    }

    GridShape shape;
    std::array<Field, 2> fields;   // 0: the ground; 1: what lies across the cut from an enriched node
    std::vector<Enrichment> cuts;  // where the two fields part: one a thin body
    std::vector<Rectangle> near;   // where points are that have to do with a cut or with a body's contact
    double point_mass = 0;         // of one point, to tell a node's mass from round-off [kg/m]
};

// Zeroes the sums of every node in use.
void clear(Grid& grid);

}  // namespace sandgraph::mpm
