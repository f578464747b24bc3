#pragma once
#include <cstdint>
#include <functional>
#include <memory>

#include "base/console.hpp"
#include "dem/assembly.hpp"

namespace sandgraph::dem {

// How a base packing is made: a gas of disks, compressed isotropically with changed friction to the target
// porosity, then rebalanced with the real friction (Liang et al. 2021, sec. 4; stages as in the YADE files).
struct Recipe {
    std::uint64_t seed = 1;
    int grains = 400;
    double r_min = 0.003, r_max = 0.007;  // radii uniform between [m]
    double pressure = 10e3;               // consolidation pressure [Pa]
    double porosity = 0.16;               // target at that pressure: 0.16 dense, 0.20 loose
    double tolerance = 0.002;             // on the porosity, absolute
    double gas_porosity = 0.45;           // of the gas before compression
    double rate = 1;   // largest normal strain rate [1/s]; up to 4 /s the porosity is the same
    double dt = 1e-5;  // [s]
};

// Makes the assembly that does the work, so that any kernel can prepare packings.
using AssemblyFactory = std::function<std::unique_ptr<Assembly>(const Packing&, const Material&)>;

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
    double dt = 1e-5;   // [s]
};
Packing compress_to(const Packing& packing, const PressureTarget& target, const Material& material,
                    const AssemblyFactory& factory, const ProgressCallback& progress = {});

// Relaxed small-strain moduli [Pa] by central probing (2D, plane strain): K = dp/d(eps_xx + eps_yy),
// G = d(tau)/d(gamma) averaged over both shear modes, M = K + G.
struct Moduli {
    double bulk = 0, shear = 0, p_wave = 0;
};
Moduli small_strain_moduli(const Packing& packing, const Material& material, const AssemblyFactory& factory,
                           double dt = 1e-5);

}  // namespace sandgraph::dem
