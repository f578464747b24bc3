#pragma once

namespace sandgraph::mpm {

// A piece of the plane, sides along x and y; its edges do not belong to it.
struct Rectangle {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // [m]
    bool contains(double x, double y) const { return x > x0 && x < x1 && y > y0 && y < y1; }
};

inline Rectangle inflated(const Rectangle& r, double by) {
    return {r.x0 - by, r.y0 - by, r.x1 + by, r.y1 + by};
}

// Nodes [i0, i1] x [j0, j1]; empty if i1 < i0.
struct NodeBox {
    int i0 = 0, j0 = 0, i1 = -1, j1 = -1;
    bool empty() const { return i1 < i0 || j1 < j0; }
};

}  // namespace sandgraph::mpm
