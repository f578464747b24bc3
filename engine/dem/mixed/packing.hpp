#pragma once
#include <vector>

#include "base/byte_stream.hpp"
#include "dem/mixed/geometry.hpp"
#include "dem/mixed/list.hpp"
#include "dem/mixed/state.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// Packing -> mixed-precision state with its pairs. Throws std::invalid_argument when the packing has more
// grains than a pair can address, or so few that a pair is not with the nearest image alone.
void load(const Packing& packing, const Material& material, MixedState& state, MixedList& list);

// The same into a state whose room, radii and masses are those of the packing.
void place(const Packing& packing, MixedState& state, MixedList& list);

// -> Packing, grains wrapped into the cell. `radii` [N].
Packing to_packing(const MixedPacking& packing, const std::vector<double>& radii);

// A packing to the bit, for checkpoints; `grains` of it are known beforehand. Loading throws StateError for
// what is no packing: the pair loop indexes by it without a look.
void save(const MixedPacking& packing, ByteWriter& out);
void load(MixedPacking& packing, int grains, double radius_max, ByteReader& in);

// Too thin a cell: two images of a grain are within reach of another.
bool too_thin(const Mat2& H, double radius_max);

}  // namespace sandgraph::dem
