#pragma once
#include <string>

#include "graph/screening_law.hpp"
#include "io/summary.hpp"

namespace sandgraph::results {

// The summary's keys of a screening run: updates, share of points answered by grains, audit, hand-over.
void add_screening(const graph::ScreeningLaw& law, io::Summary& summary);

// Who answered, why points were handed over, and how large the measured error is, a few lines.
std::string screening_text(const io::Summary& summary);

}  // namespace sandgraph::results
