#pragma once
#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// Checks what no single key can tell: whether plate, ground and pull fit together. Throws InputError at the
// line of the key to change.
void check_scene(const Scene& scene, const KeyTable& keys);

}  // namespace sandgraph::scene
