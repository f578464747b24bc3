#pragma once
#include <algorithm>

#include "mpm/rectangle.hpp"

namespace sandgraph::mpm {

// The mid-plane of a rigid plate, a straight cut along x or y. A point and a node on opposite sides of it do
// not share a velocity: the node keeps a second field for that side (as CRAMP does for cracks, Nairn 2003),
// so that soil above and below the plate neither drag nor pull each other through the plate or across a
// cavity.
struct Divide {
    bool active = false;
    bool along_x = true;        // the cut runs along x (horizontal plate) or along y
    double level = 0;           // coordinate of the cut, normal to it [m]
    double low = 0, high = 0;   // its ends [m]
    double half_thickness = 0;  // of the plate [m]

    // Whether the straight line from the point to the node crosses the cut.
    bool separates(double point_x, double point_y, double node_x, double node_y) const {
        if (!active) return false;
        return along_x ? crosses(point_y, point_x, node_y, node_x)
                       : crosses(point_x, point_y, node_x, node_y);
    }

    // Where points must be that the plate touches or whose three nodes an axis may lie across the cut: a
    // stencil reaches cell + half, a contact half_thickness + half; a quarter of a cell allows for
    // penetration.
    Rectangle reach(double cell, double half) const {
        if (!active) return {};
        const double along = 1.25 * cell + half;
        const double across = half + 0.25 * cell + std::max(cell, half_thickness);
        const Rectangle box = {low - along, level - across, high + along, level + across};
        return along_x ? box : Rectangle{box.y0, box.x0, box.y1, box.x1};
    }

  private:
    bool crosses(double n0, double s0, double n1, double s1) const {
        if ((n0 >= level) == (n1 >= level)) return false;
        const double s = s0 + (s1 - s0) * (level - n0) / (n1 - n0);
        return s >= low && s <= high;
    }
};

}  // namespace sandgraph::mpm
