#pragma once
#include <toml++/toml.h>

#include <string>

#include "base/error.hpp"

namespace sandgraph::scene {

// Whole text of `file`. Throws InputError when it cannot be read.
std::string read_text(const std::string& file);

// Parses TOML; a syntax error becomes an InputError at its line.
toml::table parse_toml(const std::string& text, const std::string& file);

// One `section.key=value` from the command line as a table. The value is TOML or, failing that, plain text,
// so that shells need no inner quotes: anchor.pull_rate=0.05 m/s.
toml::table parse_override(const std::string& assignment);

// `name = value` as a table whose nodes are in the line of `where`; the value as above. Throws InputError for
// a name that is none.
toml::table parse_value(const std::string& name, const std::string& value, const InputError::Where& where);

// How overrides call their file in errors.
inline constexpr const char* override_file = "--set";

// `base` with every value of `extra` put over its own, tables merged.
void merge(toml::table& base, const toml::table& extra);

}  // namespace sandgraph::scene
