#pragma once
#include <array>
#include <vector>

#include "mpm/boundary.hpp"
#include "mpm/grid.hpp"
#include "mpm/points.hpp"

// Nodes with next to no mass, beside a free surface, a cavity, the edge of a plate. When a row of points has
// risen by a share d of a cell, the nodes that it has just reached have a mass of d^2/2 and a force of d:
// their acceleration goes as 1/d, their share of the row's stretch as d, so that the row is stretched by g
// dt/h in every step however small d is. It gives way by lagging behind the row below by g dt: a slow plate
// does not lift the surface at all. Here such a node has no motion of its own. It follows its heavy
// neighbours linearly and gives them its mass, momentum and force by the transposed rule, so that momentum
// and virtual power are kept (as extended B-splines do at a boundary, Hoellig, Reif & Wipper 2001, SIAM J.
// Numer. Anal. 39(2), 442-462).
namespace sandgraph::mpm {

// Below this a node is light [kg/m]: a tenth of a full cell, as above a row of points that has risen by
// nearly half a cell; an eighth is what a point that stands on a node gives to the next, and round-off would
// decide. With the share between a half and a whole cell the node's own equation is as good as any other.
double light_mass(const Points& points, const GridShape& shape);

// A node, or with signs its image behind a mirror plane.
struct NodeAt {
    std::size_t field = 0, index = 0;
    double sx = 1, sy = 1;
};

// v(node) = sum of weight v(lead); the weights sum to 1.
struct Follower {
    NodeAt node;
    std::array<NodeAt, 16> lead;
    std::array<double, 16> weight{};
    std::size_t count = 0;

    void add(NodeAt of, double w) { lead[count] = of, weight[count++] = w; }
};

// Nodes of both fields lighter than `limit` [kg/m] that have a heavier neighbour of the same side of the cut,
// in a fixed order; none for limit 0. After fold().
std::vector<Follower> find_followers(const Grid& grid, const Boundaries& boundaries, double limit);
void give(const std::vector<Follower>& followers, Grid& grid);    // mass, momentum, force; before the update
void follow(const std::vector<Follower>& followers, Grid& grid);  // velocity, acceleration; after it

}  // namespace sandgraph::mpm
