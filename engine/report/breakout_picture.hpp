#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"

namespace sandgraph::report {

// Breakout factors of several runs against embedment, each series with the closed-form curve that goes with
// it.
struct BreakoutSeries {
    std::string label;              // e.g. "horizontal, dense"
    bool horizontal = true;         // Meyerhof & Adams (1968), else Biarez et al. (1965)
    double friction_angle = 0;      // of the formula [rad], mean of the runs; 0: no curve
    std::vector<double> embedment;  // H/B
    std::vector<double> n_gamma;    // N_gamma = Q_u/(B gamma H)
};

Plot breakout_plot(const std::vector<BreakoutSeries>& series);
Picture draw_breakout_picture(const std::vector<BreakoutSeries>& series, const std::filesystem::path& png);

}  // namespace sandgraph::report
