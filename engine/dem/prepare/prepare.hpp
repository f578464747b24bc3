#pragma once
#include "base/console.hpp"
#include "dem/assembly.hpp"
#include "dem/grain_scale.hpp"
#include "dem/prepare/recipe.hpp"

namespace sandgraph::dem {

struct Prepared {
    Packing packing;  // at rest, with contact history
    double porosity = 0;
    double consolidation_friction = 0;  // found by stochastic approximation [rad]
    int trials = 0;                     // consolidations done
};

// Gas -> consolidation with the friction that gives the target porosity -> real friction, rebalanced, at
// rest. Deterministic in the recipe. Throws InputError when the target is out of reach.
Prepared prepare(const Recipe& recipe, const Material& material, const AssemblyFactory& factory,
                 const ProgressCallback& progress = {});

// Disks without contacts, placed at random, largest first; `attempt` draws another gas of the same grains.
Packing random_gas(const Recipe& recipe, int attempt = 0);

// Mean stress [Pa] that grains bear lying on each other: with an overlap of p/M of a radius on average. At
// 0.2 M single overlaps pass half a radius, where no contact law holds, at 0.225 M the pores of Table 1 sand
// are gone.
double bearable_pressure(const GrainScale& grains);
// Throws InputError above it, and where grains lie in each other already.
void check_bearable(double pressure, const GrainScale& grains);
void check_uncrushed(const Packing& packing, double pressure);

// The same grains at another stress [Pa], up or down: yy at `pressure`, xx at k0 times that, both within
// `tolerance` of the pressure, shear stress as small, at rest. Both stresses go to their targets at the same
// strain rate, so that the ratio never leaves what lies between it was and what it will be by much.
struct PressureTarget {
    double pressure = 0;  // [Pa]
    double k0 = 1;        // 1: isotropic; InputError where the grains flow before they bear it
    double tolerance = 1e-3;
    double rate = 0;  // largest strain rate [1/s]; 0: 0.1 for Table 1 grains, others by their scale
    double dt = 0;    // [s]; 0: by the grains
};
Packing compress_to(const Packing& packing, const PressureTarget& target, const Material& material,
                    const AssemblyFactory& factory, const ProgressCallback& progress = {});

// Relaxed small-strain moduli [Pa] by central probing (2D, plane strain): K = dp/d(eps_xx + eps_yy),
// G = d(tau)/d(gamma) averaged over both shear modes, M = K + G.
struct Moduli {
    double bulk = 0, shear = 0, p_wave = 0;
};
Moduli small_strain_moduli(const Packing& packing, const Material& material, const AssemblyFactory& factory);

}  // namespace sandgraph::dem
