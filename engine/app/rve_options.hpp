#pragma once
#include "dem/packing.hpp"
#include "dem/rve_options.hpp"
#include "scene/scene.hpp"

namespace sandgraph::app {

// Shortest free-vibration scale of a contact, sqrt(m/k_n) of two smallest disks of radius `radius_min` [m]:
// the "critical" DEM step [s] that time_step_fraction refers to.
double critical_time_step(const dem::Material& material, double radius_min);

dem::RveOptions rve_options(const scene::RveStepping& stepping, const dem::Material& material,
                            double radius_min);

}  // namespace sandgraph::app
