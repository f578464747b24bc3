#pragma once
#include <cstdint>
#include <string>

#include "dem/packing/packing.hpp"

namespace sandgraph::packings {

// The "dense" (n = 0.16) or "loose" (0.20) base packing of Table 1 sand by our own recipe, at 10 kPa, from
// the packing cache if it is there.
dem::Packing table1_packing(const std::string& density, std::uint64_t seed, int grains);

}  // namespace sandgraph::packings
