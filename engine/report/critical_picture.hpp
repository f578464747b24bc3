#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "report/gnuplot.hpp"

namespace sandgraph::report {

// One shear test at constant mean stress [Pa] and its late void ratio.
struct CriticalCurve {
    std::string density;  // "dense" or "loose"
    double pressure = 0, void_ratio = 0;
    std::vector<dem::ShearRow> rows;
};

struct CriticalPicture {
    std::vector<CriticalCurve> curves;
    struct Line {
        double e_0 = 0, slope = 0;  // e = e_0 - slope p / 100 kPa
    };
    std::optional<Line> line;
};

// q/p, porosity and fabric anisotropy against shear strain (logarithmic, so that peak and critical state both
// show; thin lines tests, thick ones the mean of a density), and late void ratio against pressure with its
// line if it is known.
Plot critical_plot(const CriticalPicture& picture);
Picture draw_critical_picture(const CriticalPicture& picture, const std::filesystem::path& png);

}  // namespace sandgraph::report
