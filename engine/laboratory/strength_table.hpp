#pragma once
#include <span>
#include <string>

#include "laboratory/strength_row.hpp"

namespace sandgraph::laboratory {

// The rows by density with mean, standard deviation and range, beside the published values, as text for
// people and as CSV (one row a specimen, then mean, sd, min and max of each density).
std::string strength_table(std::span<const StrengthRow> rows);
std::string strength_csv(std::span<const StrengthRow> rows);

}  // namespace sandgraph::laboratory
