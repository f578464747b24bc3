#pragma once
#include <string>

#include "io/packing_file.hpp"

namespace sandgraph::packings {

// A packing from `file` (.csv or .h5). A CSV knows no material: Table 1's stands. Throws InputError.
io::PackingRecord load_packing(const std::string& file);

}  // namespace sandgraph::packings
