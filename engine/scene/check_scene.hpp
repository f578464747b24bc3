#pragma once
#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// Distance of neighbouring material points [m].
double point_spacing(const Domain& domain);

// Whether columns of points stand on the symmetry plane instead of beside it, so that the ends of a
// horizontal plate of an odd number of spacings lie between points.
bool columns_on_sides(const Scene& scene);

// Checks what no single key can tell: whether plate, ground and pull fit together. Throws InputError at the
// line of the key to change.
void check_scene(const Scene& scene, const KeyTable& keys);

}  // namespace sandgraph::scene
