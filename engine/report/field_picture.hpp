#pragma once
#include <filesystem>
#include <string>

#include "io/frame.hpp"
#include "report/gnuplot.hpp"
#include "results/field_values.hpp"
#include "results/ground_view.hpp"

namespace sandgraph::report {

// Material points as squares at their current positions, stretched with F, coloured by `quantity`; plate
// solid black; initial ground surface dashed; displacement with arrows. Equal scales.
Plot field_plot(const io::Frame& frame, results::Quantity quantity, const results::GroundView& view);
Picture draw_field_picture(const io::Frame& frame, results::Quantity quantity,
                           const results::GroundView& view, const std::filesystem::path& png);

// One line a square: x y half_x half_y value; with the mirror image if the view asks for it (a rotation
// changes its sign there).
std::string square_rows(const io::Frame& frame, const results::PointValues& shown,
                        const results::GroundView& view);

// One line an arrow: x y dx dy, about one for each `spacing` squared; the longest is `spacing` long. Empty
// when nothing moved.
std::string arrow_rows(const io::Frame& frame, const results::GroundView& view, double spacing);

}  // namespace sandgraph::report
