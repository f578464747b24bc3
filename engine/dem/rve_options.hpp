#pragma once
#include <span>

#include "dem/material.hpp"

namespace sandgraph::dem {

// Kernel of the visits: every digit double, or the faster one of dem/mixed, whose forces are float.
enum class RveKernel { double_precision, mixed };

// How an RVE follows its material point: work follows strain, not step count (DESIGN section 4).
struct RveStepping {
    double time_step_fraction = 0.85;   // DEM step as a share of the longest stable one
    double inertial_number_max = 2e-3;  // I = rate d sqrt(rho/p)
    double strain_per_step_max = 1e-5;
    double pressure_floor = 1000;         // p below which the inertial limit tightens no further [Pa]
    int steps_min = 2;                    // DEM steps of an update at least
    double stress_per_step_max = 0.015;  // elastic stress change of a step, share of p, up to settle_steps
    // A packing that goes on the way of its last update settles only as far as its strain rate is more than
    // this many times the last one; 0: always.
    double rate_jump_max = 0;
    double steady_factor = 1;     // by which the bounds on I and on a step's strain loosen at most ...
    double steady_strain = 0.01;  // ... as the strain one way comes to be so many times this
    int steps_max = 0;            // DEM steps of an update at most, the rest is for the next; 0: no bound
    RveKernel kernel = RveKernel::mixed;
};

// The same with what follows from the grains (rve_options below).
struct RveOptions : RveStepping {
    double time_step = 0;          // DEM step [s]
    double modulus = 0;            // k_n/(2 h) of two mean grains [Pa]: turns strain into elastic stress
    int settle_steps = 10;         // steps of a short update, which stress_per_step_max bounds
    double float_pressure = 10;    // mean stress taken for none when the packing has opened up [Pa]
    double float_opening = 0.005;  // volume strain beyond the last contact at which a packing floats
};

// For a packing of grains with these radii [m].
RveOptions rve_options(const RveStepping& stepping, const Material& material, std::span<const double> radii);

}  // namespace sandgraph::dem
