#pragma once
#include <string>

#include "scene/key_table.hpp"

namespace sandgraph::scene {

// Every key with its default, allowed values and meaning, table by table, as TOML that can be copied.
std::string key_help(const KeyTable& keys);

}  // namespace sandgraph::scene
