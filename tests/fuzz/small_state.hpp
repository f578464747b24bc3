#pragma once
#include <memory>

#include "graph/ground_state.hpp"

namespace sandgraph::fuzz {

// Three points whose packings have two grains each, under a screening law; the same at every call.
std::unique_ptr<graph::GroundState> small_state();

// Shears them till some points are by grains, some fade and some are audited.
void shear(graph::GroundState& state);

}  // namespace sandgraph::fuzz
