#pragma once
#include <filesystem>
#include <string>

#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// Packing as text, in the format of the YADE reference files [m]:
//   # {json metadata}
//   # cell hSize (columns = base vectors) [m]: hxx hxy hyx hyy
//   # 0.2 0 0 0.2
//   id,x,y,r
//   0,0.1,0.1,0.005
// Forces and velocities are not part of it: contact history starts at zero, grains at rest. Grains are
// ordered by id. Throws InputError on anything that is not a packing (see check_packing).
Packing read_packing_csv(const std::filesystem::path& file);

// 17 digits: reading it back gives the same bits. `metadata` is one JSON object in one line.
void write_packing_csv(const std::filesystem::path& file, const Packing& packing,
                       const std::string& metadata = "{}");

}  // namespace sandgraph::dem
