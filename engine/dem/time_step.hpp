#pragma once
#include <span>

#include "dem/material.hpp"

namespace sandgraph::dem {

inline constexpr double usual_time_step =
    1e-5;  // of preparations and element tests, as in the YADE files [s]

// Longest stable DEM step [s] of a packing of grains with these radii [m]: 2/omega of a smallest disk with as
// many of the largest around it as fit, all contacts sticking. Packings of the usual grains have their own
// limit 8 to 20 % above it (tests/physics/dem/time_step_test.cpp).
double critical_time_step(const Material& material, std::span<const double> radii);

// Step of preparations [s]: the usual one, less for smaller, stiffer or lighter grains.
double preparation_time_step(const Material& material, std::span<const double> radii);

}  // namespace sandgraph::dem
