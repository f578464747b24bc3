#pragma once
#include <algorithm>

#include "mpm/rectangle.hpp"

namespace sandgraph::mpm {

// The mid-plane of a rigid plate, a straight cut along x or y. Nodes within the plate's length keep two
// velocities, one for the points on either side, so that soil above and below neither drag nor pull each
// other through the plate or across a cavity. As with XFEM's Heaviside enrichment, only nodes whose whole
// support is cut are enriched, that is, have the second field: nodes that also see soil beside the plate's
// ends keep one, else the stress that the soil there carries around the end would be cut too (a line-crossing
// rule, Nairn 2003, does that) and rest would not be exact.
struct Enrichment {
    bool active = false;
    bool along_x = true;        // the cut runs along x (horizontal plate) or along y
    double level = 0;           // coordinate of the cut, normal to it [m]
    double low = 0, high = 0;   // the plate's ends [m]
    double half_thickness = 0;  // of the plate [m]
    double margin = 0;          // width of a stencil, cell + half: no enriched node so near to the ends [m]

    // Whether the node is enriched for a point there: the point takes part in the node's second field, that
    // of the side where the node itself is not.
    bool enriches(double point_x, double point_y, double node_x, double node_y) const {
        if (!active) return false;
        const double along = along_x ? node_x : node_y;
        if (along < low + margin || along > high - margin) return false;
        return along_x ? (point_y >= level) != (node_y >= level) : (point_x >= level) != (node_x >= level);
    }

    // Whether the cut lies between the point and a place (x, y) beside the plate.
    bool parts(double point_x, double point_y, double x, double y) const {
        const double along = along_x ? x : y;
        if (!active || along < low || along > high) return false;
        return along_x ? (point_y >= level) != (y >= level) : (point_x >= level) != (x >= level);
    }

    // Where points are that can be in contact with the plate or have a node across the cut in their stencil:
    // a stencil is `margin` wide to each side, a contact half_thickness + half; a quarter of a cell allows
    // for penetration.
    Rectangle surroundings(double cell, double half) const {
        if (!active) return {};
        const double along = half + 0.25 * cell;
        const double across = along + std::max(cell, half_thickness);
        const Rectangle box = {low - along, level - across, high + along, level + across};
        return along_x ? box : Rectangle{box.y0, box.x0, box.y1, box.x1};
    }
};

}  // namespace sandgraph::mpm
