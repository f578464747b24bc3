#pragma once
#include <filesystem>
#include <string>

#include "app/simulate.hpp"

namespace sandgraph::app {

// What to type to go on with a run that was stopped; words as a shell takes them.
std::string resume_command(const RunRequest& request, const std::filesystem::path& folder);

}  // namespace sandgraph::app
