#pragma once
#include <cstdint>

#include "dem/material.hpp"

namespace sandgraph::dem {

inline constexpr int fewest_grains = 10;  // of a packing that can stand for sand

// How a base packing is made: a gas of disks, compressed isotropically with changed friction to the target
// porosity, then rebalanced with the real friction (Liang et al. 2021, sec. 4; stages as in the YADE files).
// The scene's keys of the same names bind to these members.
struct Recipe {
    std::uint64_t seed = 1;
    int count = 400;                                // grains, fewest_grains at least
    double radius_min = 0.003, radius_max = 0.007;  // radii uniform between [m]
    double consolidation_pressure = 10e3;           // [Pa]
    double target_porosity = 0.16;                  // 2D, at that pressure: 0.16 dense, 0.20 loose
    double tolerance = 0.002;                       // on the porosity, absolute
    double gas_porosity = 0.45;                     // of the gas before compression
    double rate =
        1;  // largest normal strain rate of Table 1 grains [1/s]; up to 4 /s the porosity is the same
};

// Thickness of disks of these radii [m], unless it is told: 20 mean radii, 0.1 m for Table 1's. Overlaps grow
// with thickness over radius (p depth / (E r)), so that a fixed one would press small grains into each other.
inline double usual_depth(double radius_min, double radius_max) {
    constexpr Recipe table1;
    return Material{}.depth * ((radius_min + radius_max) / (table1.radius_min + table1.radius_max));
}

}  // namespace sandgraph::dem
