#pragma once
#include <string>

#include "dem/packing/packing.hpp"

namespace sandgraph::io {

// Throws InputError unless lengths agree, contacts lie inside and dem::check_packing accepts the packing.
void check_stored_packing(const dem::Packing& packing, const std::string& file);

}  // namespace sandgraph::io
