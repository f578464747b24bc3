#pragma once
#include <string>
#include <vector>

#include "report/sweep_picture.hpp"
#include "results/sweep_results.hpp"

namespace sandgraph::report {

inline constexpr std::size_t histogram_from = 20;  // samples

// N against the first axis; a curve for each choice of the others.
SweepPicture sweep_picture(const simulation::SweepPlan& plan,
                           const std::vector<results::SweepRowResult>& rows);

// chart.png, histogram_ROW.png of rows with many samples and index.html, which links rows to their runs, in
// the sweep's folder. Returns what could not be drawn, a line; else nothing.
std::string write_sweep_page(const simulation::SweepPlan& plan,
                             const std::vector<results::SweepRowResult>& rows);

}  // namespace sandgraph::report
