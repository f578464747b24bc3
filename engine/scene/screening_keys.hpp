#pragma once
#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// [surrogate], [gate] and [audit]. They change results only in a screening run.
void add_screening_keys(KeyTable& keys, Screening& screening, bool in_use);

}  // namespace sandgraph::scene
