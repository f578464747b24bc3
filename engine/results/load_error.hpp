#pragma once
#include <span>
#include <string>

#include "io/frame.hpp"
#include "io/summary.hpp"
#include "results/peak.hpp"

namespace sandgraph::results {

// What a run whose law audits its load says of the load's error, of its rows: the mean correction about the
// breakout and the half widths there and over the last tenth of the curve, as shares of the breakout load.
void add_load_error(std::span<const io::LoadRow> rows, const Breakout& breakout, io::Summary::Audit& audit);

std::string load_error_text(const io::Summary& summary);  // a line, or nothing where nothing audits

}  // namespace sandgraph::results
