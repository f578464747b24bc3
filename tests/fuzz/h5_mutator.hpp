#pragma once
#include <cstdint>
#include <vector>

namespace sandgraph::fuzz {

// Makes up to four changes in the whole HDF5 file that `bytes` hold: to attributes, to a dataset's numbers,
// type or extent, to links. It does so through HDF5, so that all checksums fit and the changes reach what our
// readers make of them; of blind changes HDF5's own checksums stop nearly all. False, and nothing changed,
// when HDF5 refuses. Never give it a damaged file: HDF5 1.10 crashes on some.
bool mutate_h5(std::vector<std::uint8_t>& bytes, unsigned seed);

}  // namespace sandgraph::fuzz
