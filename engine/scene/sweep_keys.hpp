#pragma once
#include <string>

#include "scene/key_table.hpp"
#include "scene/sweep_spec.hpp"

namespace sandgraph::scene {

// The keys of a sweep's table, filling `spec`, which must outlive the table.
KeyTable sweep_keys(SweepSpec& spec);

// Reads a table; keys and values of scenes in it are not looked at (sweep_rows.hpp). Throws InputError.
SweepSpec read_sweep(const std::string& file);

}  // namespace sandgraph::scene
