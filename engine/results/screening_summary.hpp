#pragma once
#include <string>

#include "io/summary.hpp"
#include "stress/law.hpp"

namespace sandgraph::results {

// The summary's keys of a screening run: updates, share of points answered by grains, audit, hand-over.
void add_screening(const stress::Law& law, std::size_t points, io::Summary& summary);

// Who answered, why points were handed over, and how large the measured error is, a few lines.
std::string screening_text(const io::Summary& summary);

}  // namespace sandgraph::results
