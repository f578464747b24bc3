#pragma once
#include <string>

#include "packings/in_situ.hpp"

namespace sandgraph::results {

// Has the surrogate of a screening run seen sand like this? Its model knows the range of what it was trained
// on: pressure, void ratio, coordination and peak friction of packings at rest.
struct KnownSand {
    double distance =
        0;              // of the row that lies furthest outside that range, in widths of the range; 0: inside
    bool known = true;  // as near as the gate of a default scene would let the surrogate answer
};
// `ground` must have a surrogate and its traits.
KnownSand known_sand(const packings::PreparedGround& ground);

// The warning of a run whose gate is off, in a line; empty where the sand is known.
std::string unknown_sand_text(const KnownSand& sand, const packings::PreparedGround& ground);

}  // namespace sandgraph::results
