#pragma once
#include <vector>

#include "graph/ground_state.hpp"
#include "graph/phase.hpp"

namespace sandgraph::graph {

// The phases of one step over the state, in reading order. The state must outlive them.
//   points to grid -> plate contact -> grid update -> grid to points -> stress (predict, route, drive)
std::vector<Phase> step_phases(GroundState& state);

}  // namespace sandgraph::graph
