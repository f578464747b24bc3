#pragma once
#include <vector>

#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// Ids of the grains along strips of the cell, about a grain wide: neighbours in space become neighbours in
// memory, so that the pair loop of a large packing stays in the near caches. Size N, a permutation.
std::vector<int> strip_order(const Packing& packing);

// Grain k of the result is grain order[k]; contacts follow. `order` is a permutation of 0 .. N-1.
Packing reordered(const Packing& packing, const std::vector<int>& order);

// The permutation that undoes `order`.
std::vector<int> inverse_order(const std::vector<int>& order);

}  // namespace sandgraph::dem
