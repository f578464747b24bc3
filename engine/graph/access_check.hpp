#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "graph/ground_state.hpp"
#include "graph/phase.hpp"

namespace sandgraph::graph {

// One number for each datum of a step, another one as soon as a bit of it is another. What a law keeps for
// itself (visits, due, answers, packings, law) shares one: that of its archive.
std::array<std::uint64_t, stress::data_count> fingerprints(GroundState& state);

// Runs the phases of a step over `state` one after the other and looks at what each has changed: throws
// std::logic_error, naming phase and datum, where that is not declared as written. Development builds run
// their first steps this way.
void run_checked(const std::vector<Phase>& phases, GroundState& state);

}  // namespace sandgraph::graph
