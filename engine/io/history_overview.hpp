#pragma once
#include <string>

#include "io/history.hpp"

namespace sandgraph::io {

// Counts for people: packings by density, histories and updates by path, twins.
std::string history_overview(const HistoryLog& log);

}  // namespace sandgraph::io
