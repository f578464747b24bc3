#pragma once
#include <cstdint>
#include <string>

#include "scene/scene.hpp"

namespace sandgraph::scene {

// Every value that changes results, one "section.key=value" a line in SI; the same for two
// files that mean the same. A packing file stands with the hash of its content.
std::string canonical_text(const Scene& scene);

// Hash of the canonical text, stable across machines and versions that know the same keys.
std::uint64_t scene_hash(const Scene& scene);

}  // namespace sandgraph::scene
