#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "stability/suite.hpp"

namespace sandgraph::stability {

// A hash of every file in the folder of a finished run: texts as they are, the entries of summary.json, every
// attribute and dataset of HDF5 files. Left out is only what tells of the clock and of the threads.
std::map<std::string, std::string> digest(const std::filesystem::path& folder);

// The outputs that differ or are missing in one of the two.
std::vector<std::string> differences(const std::map<std::string, std::string>& a,
                                     const std::map<std::string, std::string>& b);

// Checks that there are none; names the first ones.
void check_same(const std::string& what, const std::vector<std::string>& differences, Findings& found);

}  // namespace sandgraph::stability
