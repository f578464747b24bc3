#pragma once
#include "base/console.hpp"
#include "dem/assembly.hpp"
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

// The same grains at another isotropic pressure [Pa], up or down: both normal stresses within `tolerance`
// (relative) of it, shear stress as small, at rest.
struct PressureTarget {
    double pressure = 0;  // [Pa]
    double tolerance = 1e-3;
    double rate = 0.1;  // largest strain rate [1/s]
    double dt = 0;      // [s]; 0: preparation_time_step of the packing
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
