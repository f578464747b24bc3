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

}  // namespace sandgraph::report
