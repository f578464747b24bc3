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

}  // namespace sandgraph::dem
