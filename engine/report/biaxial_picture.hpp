#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "report/gnuplot.hpp"

namespace sandgraph::report {

// Biaxial tests of several packings at one confining pressure [Pa]; rows at the same axial strains.
struct BiaxialSeries {
    double confining_pressure = 0;
    std::vector<std::vector<dem::BiaxialRow>> tests;
};

struct BiaxialPicture {
    std::string title;
    std::vector<BiaxialSeries> series;
};

// Mobilised friction q/p over volumetric strain (dilation up), both against axial strain, as a soil
// laboratory draws them: a thin line a packing, a thick one for the mean of each pressure.
Plot biaxial_plot(const BiaxialPicture& picture);
Picture draw_biaxial_picture(const BiaxialPicture& picture, const std::filesystem::path& png);

// The mean of a series row by row, as far as its shortest test goes: axial strain, q/p, dilation -eps_v.
struct BiaxialPoint {
    double axial_strain = 0, sin_phi = 0, dilation = 0;
};
std::vector<BiaxialPoint> mean_test(const BiaxialSeries& series);

}  // namespace sandgraph::report
