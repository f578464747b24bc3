#pragma once
#include "base/console.hpp"
#include "dem/assembly.hpp"
#include "dem/grain_scale.hpp"
#include "dem/material.hpp"

namespace sandgraph::dem {

// The stages that preparations are made of. Stress compression positive.

// Servo on the periods: yy to `pressure`, xx to k0 times that, and the shear stress to zero if asked.
// Dense-packing strain rates stay below `rate`.
struct PressureStage {
    double pressure = 0;  // [Pa]
    double k0 = 1;
    double tolerance = 1e-3;
    double rate = 0;  // [1/s]
    GrainScale grains;
    double dt = 0;  // [s]
    bool release_shear = false;
};

// Strain rate at which the servo closes a packing without stress [1/s].
double largest_rate(const PressureStage& stage);
// True when the stress is within the tolerance.
bool at_pressure(const Mat2& stress, const PressureStage& stage);
// Drives until the stress stayed within the tolerance for a while; false when `max_steps` were not enough.
bool drive_to_pressure(Assembly& assembly, const PressureStage& stage, long max_steps,
                       const ProgressCallback& progress);
// Frozen cell, until the mean unbalanced force is below `unbalanced` (relative); false when `max_steps` ran
// out.
bool relax(Assembly& assembly, double unbalanced, double dt, long max_steps);

// Velocities and the pending motion of the cell dropped.
Packing at_rest(Packing packing);

// Local damping of stages where only the end state counts: vibrations die out in some 10 ms.
inline Material calm(Material material) {
    material.damping = 0.5;
    return material;
}

}  // namespace sandgraph::dem
