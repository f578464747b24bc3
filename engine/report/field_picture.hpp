#pragma once
#include <filesystem>
#include <string>

#include "io/frame.hpp"
#include "report/field_values.hpp"
#include "report/gnuplot.hpp"

namespace sandgraph::report {

// The setting of a field picture [m].
struct GroundView {
    std::string title;              // of the scene
    double width = 6, surface = 5;  // domain 0..width, initial ground surface at y = surface
    double point_size = 0.1;        // initial edge of a material point's square
    double anchor_width = 1;        // B, for the axis in x/B
    bool has_plate = true;
    double plate_size_x = 1, plate_size_y = 0.1;  // of the whole plate; its centre comes with the frame
    double window = 0;                            // half width shown about the plate [m]; 0: the whole ground
    bool mirror = false;                          // half model: draw its mirror image about x = 0 too
};

// Material points as squares at their current positions, stretched with F, coloured by `quantity`; plate
// solid black; initial ground surface dashed; displacement with arrows. Equal scales.
Plot field_plot(const io::Frame& frame, Quantity quantity, const GroundView& view);
Picture draw_field_picture(const io::Frame& frame, Quantity quantity, const GroundView& view,
                           const std::filesystem::path& png);

}  // namespace sandgraph::report
