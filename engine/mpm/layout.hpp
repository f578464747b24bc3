#pragma once
#include <functional>
#include <vector>

#include "mpm/points.hpp"
#include "mpm/rectangle.hpp"

namespace sandgraph::mpm {

struct Layout {
    Rectangle ground;                 // whole number of point spacings wide and high
    double cell = 0.1;                // [m]
    int points_per_cell = 1;          // 1, 4 or 9
    double density = 0;               // in situ, rho_grain (1 - n) [kg/m3]
    std::vector<Rectangle> cavities;  // no ground there: the bodies' initial volume
    // Whether there is ground about a point of the rectangle; empty: everywhere.
    std::function<bool(double x, double y)> inside = {};
    // Columns stand on the left and right sides, mirror planes, instead of half a spacing beside them. Of
    // those points the half inside counts.
    bool columns_on_sides = false;
};

// Rows from the base up, each from left to right. Ids follow that order; `row` counts from the surface (0)
// down; `surface` lists row 0. Depth of a row's centre is (row + 1/2) 2 half.
Points lay_out(const Layout& layout);

}  // namespace sandgraph::mpm
