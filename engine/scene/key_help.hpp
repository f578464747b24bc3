#pragma once
#include <string>

#include "scene/effects.hpp"
#include "scene/key_table.hpp"

namespace sandgraph::scene {

// Every key with its default, allowed values and meaning, table by table, as TOML that can be copied; behind
// a
// '#' what would have no effect beside the other defaults.
std::string key_help(const KeyTable& keys, FileKind kind);

}  // namespace sandgraph::scene
