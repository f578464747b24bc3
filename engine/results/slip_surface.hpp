#pragma once
#include <vector>

#include "io/frame.hpp"
#include "results/ground_view.hpp"

// How far friction is mobilised on the surface through a horizontal plate's edge: the column above the plate
// is lifted by its own weight plus the shear on its two vertical sides, N = 1 + 2 int tau dy / (B gamma H).
namespace sandgraph::results {

// Stress [Pa, compression positive] on the vertical line half a point outside the plate's edge, one value a
// row of points from the plate's initial top face to the surface, lowest first. NaN where no point is near,
// and below the plate's present top face.
struct EdgeStress {
    std::vector<double> normal, shear, vertical;  // |sigma_xx|, |sigma_xy|, sigma_yy
};
EdgeStress edge_stress(const io::Frame& start, const io::Frame& frame, const GroundView& view);

// A slip surface is past (before) its peak where tau/sigma_xx is below 0.9 of the row's largest of all frames
// and that came earlier (later). Shares and means are weighted with the normal stress.
struct SlipSurface {
    double K = 0;         // int sigma_xx dy over the initial int sigma_yy dy, the K_u of Meyerhof & Adams
    double friction = 0;  // int tau dy / int sigma_xx dy, mean tan(delta)
    double greatest = 0;  // the same with each row's largest ratio of all frames
    double before = 0, past = 0;  // shares
};

// One for each frame of one run but the first, which is the ground before the pull.
std::vector<SlipSurface> slip_surfaces(const std::vector<EdgeStress>& frames);

}  // namespace sandgraph::results
