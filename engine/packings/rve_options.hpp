#pragma once
#include <span>

#include "dem/rve.hpp"
#include "scene/scene.hpp"

namespace sandgraph::packings {

// Longest stable DEM step [s] of a packing of grains with these radii [m]: 2/omega of a smallest disk with as
// many of the largest around it as fit, all contacts sticking. Packings of the usual grains have their own
// limit 8 to 20 % above it (tests/physics/dem/time_step_test.cpp).
double critical_time_step(const dem::Material& material, std::span<const double> radii);

// Step of preparations and element tests [s]: 1e-5 s as in the YADE files, less for smaller, stiffer or
// lighter grains.
double preparation_time_step(const dem::Material& material, std::span<const double> radii);

dem::RveOptions rve_options(const dem::RveStepping& stepping, const dem::Material& material,
                            std::span<const double> radii);

}  // namespace sandgraph::packings
