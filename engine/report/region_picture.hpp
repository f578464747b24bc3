#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/region_series.hpp"
#include "report/gnuplot.hpp"

namespace sandgraph::report {

struct RegionPicture {
    std::string title;
    std::vector<io::RegionSeries> regions;
    bool by_time = false;  // in ground without a plate: against time
};

// Strain, porosity, fabric anisotropy, deviator, earth pressure coefficient and rotation of each region
// against d/B: the mean as a line, the range as a shadow.
Plot region_plot(const RegionPicture& picture);
Picture draw_region_picture(const RegionPicture& picture, const std::filesystem::path& png);

// The critical state of the grains: q = stress_ratio p and e = e_0 - slope p / 100 kPa.
struct CriticalLines {
    double stress_ratio = 0, e_0 = 0, slope = 0;
};
// Means over the tests of a critical_state.csv (`sandgraph rve critical`), the line of e by least squares.
// InputError when the file is no such table.
CriticalLines read_critical_lines(const std::filesystem::path& csv);

// Paths of the regions' means in p-q and p-e, their ends marked, with the critical state lines if they are
// known.
Plot stress_path_plot(const RegionPicture& picture, const std::optional<CriticalLines>& lines);
Picture draw_stress_path_picture(const RegionPicture& picture, const std::optional<CriticalLines>& lines,
                                 const std::filesystem::path& png);

}  // namespace sandgraph::report
