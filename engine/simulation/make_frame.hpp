#pragma once
#include "dem/material.hpp"
#include "io/frame.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::simulation {

// The ground as it stands, with the fields of every frame: displacement [m], velocity [m/s], F [-] (xx, xy,
// yx, yy), stress [Pa] (xx, yy, xy, compression positive), mean stress p and deviator q [Pa], porosity, and
// whether the point owns a packing, its contact fabric (xx, yy, xy), fabric anisotropy F_a and coordination
// number; in a screening run graph::PointMode ("mode") and the audit's stress error, share of p (NaN where no
// audit looks). `start`: where the points were before the first step.
io::Frame make_frame(const Simulation& simulation, const std::vector<Vec2>& start, double initial_porosity,
                     const dem::Material& material);

// Porosity of a point under any law; a closed-form law starts from `initial_porosity`.
double point_porosity(const graph::GroundState& state, std::size_t point, double initial_porosity);

}  // namespace sandgraph::simulation
