#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"
#include "results/peak.hpp"

namespace sandgraph::report {

// One run in the load-displacement picture.
struct LoadCurve {
    std::string label;
    std::vector<double> d_over_B;
    std::vector<double> load;    // of the whole plate [N/m]
    double unit_load = 1;        // B gamma H [N/m]: N_gamma = load/unit_load
    results::Breakout breakout;  // marked unless d_over_B of it is 0
    // Of runs whose law audits its load: without its error, with the 95 % interval as a band [N/m]. Else
    // empty.
    std::vector<double> corrected = {}, low = {}, high = {};
};

// A closed-form breakout factor, drawn as a labelled horizontal line.
struct ReferenceLine {
    std::string label;
    double n_gamma = 0;
};

struct LoadPicture {
    std::string title;
    std::vector<LoadCurve> curves;
    std::vector<ReferenceLine> references;
};

// Load over d/B, of a single curve with its error bar: N_gamma on the left axis; load [kN/m] on the right one
// when all curves share their unit_load.
Plot load_plot(const LoadPicture& picture);
Picture draw_load_picture(const LoadPicture& picture, const std::filesystem::path& png);

}  // namespace sandgraph::report
