#pragma once
#include <span>

#include "dem/material.hpp"

namespace sandgraph::dem {

// Of preparations and element tests of Table 1 grains, as in the YADE files [s].
inline constexpr double usual_time_step = 1e-5;

// Longest stable DEM step [s] of a packing of grains with these radii [m]: 2/omega of a smallest disk with as
// many of the largest around it as fit, all contacts sticking. Packings of the usual grains have their own
// limit 8 to 20 % above it (tests/physics/dem/time_step_test.cpp).
double critical_time_step(const Material& material, std::span<const double> radii);

}  // namespace sandgraph::dem
