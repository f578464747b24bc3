#pragma once
#include <string>

#include "io/packing_file.hpp"

namespace sandgraph::io {

// Throws InputError unless lengths agree, contacts lie inside and dem::check_packing accepts the packing.
void check_packing_record(const PackingRecord& record, const std::string& file);

}  // namespace sandgraph::io
