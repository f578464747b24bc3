#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/frame.hpp"
#include "report/colour_scale.hpp"
#include "report/gnuplot.hpp"
#include "results/field_values.hpp"
#include "results/ground_view.hpp"

namespace sandgraph::report {

// Colours of a field in one frame; those of a run's pictures are joined over all its frames.
ColourRange field_range(const io::Frame& frame, results::Quantity quantity, const results::GroundView& view);

// Material points as squares at their current positions, stretched with F, coloured by `quantity` within
// `range`; depth below the initial surface downwards; plate solid black; initial ground surface dashed;
// displacement with arrows and their scale. Equal scales.
Plot field_plot(const io::Frame& frame, results::Quantity quantity, const results::GroundView& view,
                const ColourRange& range);

// The same as a file in each format. A field that the frame lacks is a message, too.
Picture draw_field_picture(const io::Frame& frame, results::Quantity quantity,
                           const results::GroundView& view, const ColourRange& range,
                           const std::filesystem::path& png, const std::vector<std::string>& formats);

// One line a square: x depth half_x half_y value [m]; with the mirror image if the view asks for it (a
// rotation changes its sign there).
std::string square_rows(const io::Frame& frame, const results::PointValues& shown,
                        const results::GroundView& view);

// How arrows are drawn.
struct ArrowScale {
    double spacing = 0.1;  // one arrow for each `spacing` squared of the ground before the pull [m]
    double length = 1;     // drawn length over displacement
    double least = 0;      // shorter displacements have none [m]
    double shown = 0;      // the displacement drawn beside the picture as a scale [m]; 0: no arrow at all
};

// The longest arrow is as long as the spacing. None where nothing has moved by more than 1 % of the range of
// colours.
ArrowScale arrow_scale(const io::Frame& frame, const results::GroundView& view, const ColourRange& range);

// One line an arrow, the mean of the points in a square of `spacing`: x depth dx d_depth [m], depth
// downwards. Empty when nothing moved.
std::string arrow_rows(const io::Frame& frame, const results::GroundView& view, const ArrowScale& scale);

}  // namespace sandgraph::report
