#pragma once
#include <cstdint>

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

}  // namespace sandgraph::dem
