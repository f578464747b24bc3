#pragma once
#include <vector>

#include "dem/fast/state.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// Packing -> working state with an empty pair list (NeighbourList::relist fills it from packing.contacts).
// Throws std::invalid_argument when the packing has more grains than a pair can address.
void load(const Packing& packing, const Material& material, FastState& state);

// The pairs that hold a force, i.e. what a packing must remember.
void contact_history(const FastState& state, std::vector<Contact>& out);

// Working state -> packing.
Packing unload(const FastState& state);

// Room for n grains and the padding grain of the pairs that fill up the last lanes of the pair loop: tiny, at
// the origin, where the mean field leaves it at rest.
void resize_grains(FastState& state, int n);

inline void set_grain(double* record, double x, double y, double vx, double vy, double r, double spin) {
    record[0] = x, record[1] = y, record[2] = vx, record[3] = vy;
    record[4] = record[7] = r, record[5] = r * spin, record[6] = spin;
}

constexpr int padded(int n) { return (n + FastState::kLanes - 1) / FastState::kLanes * FastState::kLanes; }

// Ids of the grains along strips of the cell, about a grain wide: neighbours in space become neighbours in
// memory, so that the pair loop of a large packing stays in the near caches. Size N, a permutation.
std::vector<int> strip_order(const Packing& packing);

// The order in which the kernels keep grains: a small packing lies in the nearest cache in any order and
// keeps that of its maker, a large one is put into strips.
std::vector<int> memory_order(const Packing& packing);

// Grain k of the result is grain order[k]; contacts follow. `order` is a permutation of 0 .. N-1.
Packing reordered(const Packing& packing, const std::vector<int>& order);

// The permutation that undoes `order`.
std::vector<int> inverse_order(const std::vector<int>& order);

}  // namespace sandgraph::dem
