#pragma once
#include "io/frame.hpp"
#include "results/ground_view.hpp"

// How far a failure reaches and how its shear band lies, by rules that need no eye. Lengths in plate widths
// B.
namespace sandgraph::results {

// The ground surface: the points whose row lay at the surface at first. An edge is where the rise has fallen
// to a tenth of the plate's travel d; 0 where nothing rose or sank that much.
struct SurfaceShape {
    double highest = 0, lowest = 0;  // rise of the surface, as a share of d
    double visible_ahead = 0;        // farthest rise of B/100, what a picture shows
    double heave_ahead = 0;  // farthest rise from the plate's start; horizontal plate: from the centre line
    double sink_behind = 0;  // farthest sink behind a vertical plate's start
};
SurfaceShape surface_shape(const io::Frame& frame, const GroundView& view);

// Points strained past eps_eq = 0.1, as they lie, from the plate's present centre.
struct StrainedZone {
    double ahead = 0, behind = 0;  // to +x and -x (horizontal plate: both sides alike)
    double above = 0, below = 0;
};
StrainedZone strained_zone(const io::Frame& frame, const GroundView& view);

// Share of the track that a horizontal plate has left (its width times d, below its lower face) that no
// point's square covers: 1 is an open cavity, 0 a filled one.
double cavity_share(const io::Frame& frame, const GroundView& view);

// The shear band over a horizontal plate's right half: in each row of points from the plate to the surface
// its place is the strain-weighted mean x of the points with at least half the row's largest equivalent
// strain, within 0.3 B of that one. Straight lines through the lower, middle and upper third of the rows give
// its angles [deg to the horizontal; below 90 it leans outwards]. NaN without three rows.
struct ShearBand {
    double lower = 0, middle = 0, upper = 0;
    double at_surface = 0;  // x/B where it meets the surface
    // Outer edge of the points strained past 0.2 in the uppermost half width, where a band may bend outwards
    // [deg]; the same of the points strained past 0.1.
    double edge_at_surface = 0, faint_edge_at_surface = 0;
    // Dilation angle of the band's points, sin psi = sum d_eps_v / sum d_gamma, gamma = |ln l1 - ln l2|
    // [deg].
    double dilation = 0;
};
// Of the strain between two frames: F_late F_early^-1.
ShearBand shear_band(const io::Frame& early, const io::Frame& late, const GroundView& view);

// What 95 % of the points above a horizontal plate's top face that are strained past 0.2 do not exceed in
// |rotation| [deg]; NaN without such points.
double band_rotation(const io::Frame& frame, const GroundView& view);

}  // namespace sandgraph::results
