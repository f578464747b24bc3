#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"

namespace sandgraph::report {

// One run of a speed-against-error study. NaN: not known, not drawn.
struct ParetoMark {
    std::string label;  // the gate's threshold
    double speedup = 1;
    double peak_error = 0, curve_error = 0;  // shares of the reference's peak
    double audit_mean = 0, audit_ci95 = 0;   // the run's own estimate, share of p
    double true_error = 0;                   // mean stress error over all points, share of p
};

struct ParetoPicture {
    std::string title;
    std::vector<ParetoMark> marks;
};

// Two panels over the speed-up: errors of the load curve; the audit's estimate with its interval and the
// truth.
Plot pareto_plot(const ParetoPicture& picture);
Picture draw_pareto_picture(const ParetoPicture& picture, const std::filesystem::path& png);

}  // namespace sandgraph::report
