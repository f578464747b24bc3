#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"

namespace sandgraph::report {

// N_gamma of a sweep's rows.
struct SweepPicture {
    struct Mark {
        double at = 0;                              // on the axis
        double n_gamma = 0, ci95 = 0, formula = 0;  // NaN: not known
    };
    struct Curve {
        std::string label;
        std::vector<Mark> marks;
    };
    std::string title, axis;          // axis: what is varied first
    std::vector<std::string> places;  // names of 0, 1, ... on the axis; empty: it is one of numbers
    std::vector<Curve> curves;
};
// Bars: the 95 % intervals; broken lines: the closed form of the same colour.
Plot sweep_plot(const SweepPicture& picture);

// How often N_gamma came out where, of one row; `values` are not empty.
struct HistogramPicture {
    std::string title;
    std::vector<double> values;
};
Plot histogram_plot(const HistogramPicture& picture);

}  // namespace sandgraph::report
