#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace sandgraph::stability {

// A hash of each output of a finished run: load.csv, fields.xdmf and summary.json, and every group, attribute
// and dataset of run.h5 and history.h5. Left out is only what tells of the clock and of the threads.
std::map<std::string, std::string> digest(const std::filesystem::path& folder);

// How many outputs differ or are missing in one of the two.
int differences(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b);

}  // namespace sandgraph::stability
