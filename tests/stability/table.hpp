#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "stability/suite.hpp"

namespace sandgraph::stability {

// The rows of a table of outcomes: one a check.
std::string markdown(std::span<const Outcome> outcomes);
std::string csv(std::span<const Outcome> outcomes);

// What csv() wrote, to six digits. std::runtime_error when it is another file.
std::vector<Outcome> read_csv(const std::filesystem::path& file);

// FILE.md, with what was counted above the table, and FILE.csv; each is replaced as a whole.
void write_tables(const std::string& file, const std::string& command, std::span<const Outcome> outcomes);

}  // namespace sandgraph::stability
