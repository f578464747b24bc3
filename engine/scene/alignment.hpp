#pragma once
#include "scene/scene.hpp"

// How grid and points lie beside the ends of the loaded body: docs/how_it_works.md, "Ends of faces".
namespace sandgraph::scene {

// Distance of neighbouring material points [m].
double point_spacing(const Domain& domain);

// Whether the grid is moved by half a cell along x or y.
bool shifts_x(const Scene& scene);
bool shifts_y(const Scene& scene);

// Whether columns of points stand on the symmetry plane instead of beside it. With one point a cell: where
// the grid is moved, so that the point stands at the centre of its cell and the ends of a plate, midway
// between nodes, halve points. (On a node it would take its strain from two cells: bands twice as wide, and a
// surface over a shallow plate that lags by 10 %.) Otherwise where a half plate is an odd number of points
// wide.
bool columns_on_sides(const Scene& scene);

// Whether the sides of a body may halve points instead of lying between them.
bool halves_points(const Scene& scene);

}  // namespace sandgraph::scene
