#pragma once
#include "base/byte_stream.hpp"
#include "dem/mixed/state.hpp"

namespace sandgraph::dem {

// A packing to the bit, for checkpoints; `grains` of it are known beforehand. Loading throws StateError for
// what is no packing: the pair loop indexes by it without a look.
void save(const MixedPacking& packing, ByteWriter& out);
void load(MixedPacking& packing, int grains, double radius_max, ByteReader& in);

}  // namespace sandgraph::dem
