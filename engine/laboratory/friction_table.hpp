#pragma once
#include <span>
#include <string>

#include "laboratory/friction_row.hpp"

namespace sandgraph::laboratory {

// The rows by density with mean, standard deviation and range, beside the published values, as text for
// people and as CSV (one row a specimen, then mean, sd, min and max of each density).
std::string friction_table(std::span<const FrictionRow> rows);
std::string friction_csv(std::span<const FrictionRow> rows);

}  // namespace sandgraph::laboratory
