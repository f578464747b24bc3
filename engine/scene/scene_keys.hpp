#pragma once
#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// The keys of a scene file, filling `scene`, which must outlive the table.
KeyTable scene_keys(Scene& scene);

}  // namespace sandgraph::scene
