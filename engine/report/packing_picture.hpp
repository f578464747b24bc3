#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "dem/packing/observe.hpp"
#include "report/gnuplot.hpp"

namespace sandgraph::report {

struct PackingPicture {
    std::string title;
    dem::Packing packing;
    dem::Material material;
    // The packing's earliest known cell, drawn dotted.
    struct FirstCell {
        Mat2 H;
        double d_over_B = 0;
    };
    std::optional<FirstCell> first_cell;
};

// Left the grains with their force chains: a bar from centre to centre at each contact, as thick as its
// normal force. Right the rose of contact directions in sectors of 10 deg, 1 where contacts point everywhere
// alike, with 1 + F_a cos 2(theta - theta_a) of the fabric tensor.
Plot packing_plot(const PackingPicture& picture);
Picture draw_packing_picture(const PackingPicture& picture, const std::filesystem::path& png);

}  // namespace sandgraph::report
