#pragma once
#include <string>

#include "io/frame.hpp"
#include "scene/scene.hpp"

namespace sandgraph::results {

// How the pictures and measures of a scene's ground look at it [m].
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

// The plate and about two widths around it; without a plate the whole ground.
GroundView ground_view(const scene::Scene& scene);

// What the moments of a run are told by: d/B, in ground without a plate time [s]; and as a text.
double mark_of(const io::Frame& frame, const GroundView& view);
std::string moment_text(double mark, bool has_plate);

}  // namespace sandgraph::results
