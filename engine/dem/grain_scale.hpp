#pragma once
#include <span>

#include "dem/material.hpp"

namespace sandgraph::dem {

struct Packing;

// What the times, rates and pressures of preparations and element tests are multiples of. Their published
// values belong to the grains of Table 1 (Liang et al. 2021); grains whose contacts vibrate `slowness` times
// as slowly, `stiffness` times as stiff, take them times these factors, and tests of similar packings are
// then similar. Packings of few Table 1 grains scatter about them: within 20 % a factor is 1 exactly.
struct GrainScale {
    double diameter = 0;   // mean [m]
    double density = 0;    // of the grains [kg/m3]
    double modulus = 0;    // k_n/(2 h) of two mean grains [Pa]: the order of a packing's P-wave modulus
    double time_step = 0;  // of preparations and tests [s]
    double slowness = 1;   // d sqrt(rho/M) over that of Table 1
    double stiffness = 1;  // M over that of Table 1
};

// `factor`, but 1 within 20 %: packings of few Table 1 grains scatter about the mean ones and keep the
// published values to the bit.
constexpr double unless_near_one(double factor) {
    constexpr double near = 1.2;
    return factor < near && factor * near > 1 ? 1 : factor;
}

// Of grains with these radii [m], of which there is one at least.
GrainScale grain_scale(std::span<const double> radii, const Material& material);
GrainScale grain_scale(const Packing& packing, const Material& material);

// rate d sqrt(rho/p), `rate` in 1/s; 0 without pressure.
double inertial_number(double rate, double p, const GrainScale& grains);

}  // namespace sandgraph::dem
