#pragma once
#include <toml++/toml.h>

#include <cstdint>
#include <string>

namespace sandgraph::scene {

// The kinds of TOML files that commands take.
enum class FileKind : std::uint8_t { scene, element_test, recipe, probe, train, sweep };

// Throws InputError when `table` is of another kind, told by the tables and keys that only that kind has, and
// says which command takes it. A file that shows no kind, or `wanted` beside another, passes.
void require_kind(const toml::table& table, const std::string& file, FileKind wanted);

}  // namespace sandgraph::scene
