#pragma once
#include <vector>

#include "dem/fast/neighbours.hpp"
#include "dem/fast/state.hpp"
#include "dem/mixed/state.hpp"

// The inner loops of the mixed-precision DEM step, dispatched at run time to the widest instruction set of
// the machine: the equations of fast/kernel.hpp with forces and velocities in float, positions in integer
// shares of the period and overlaps in double.
namespace sandgraph::dem {

// Contact forces at the current positions; advances the contact history by dt. `moment_sum`, if given,
// receives sum over contacts of d (x) f as (xx, xy, yx, yy) [N m]. A move must come before: it lays out the
// grains for the pairs.
void contact_forces(MixedState& state, const KernelConstants& k, double dt, double* moment_sum);

// Velocities from the forces. This and the next two return the largest (speed beside the mean
// field/allowance) squared [1/s2], not a number once a velocity is not finite.
double kick(MixedState& state, const KernelConstants& k, double dt);

// Kick, then the mean field jumps to the velocity gradient L, and grains and cell move: one pass.
double kick_drift(MixedState& state, const KernelConstants& k, const Mat2& L, double dt);

// The jump to L and the move alone; dt = 0 only lays out the grains.
double drift(MixedState& state, const Mat2& L, double dt);

// All pairs i < j nearer than reach_i + reach_j [m], images left open; `reach` [room]. Every grain is held
// against every other, which for a few hundred is faster than a search by bins.
void near_pairs(const MixedPacking& packing, const Aligned<float>& reach, std::vector<NearPair>& pairs);

}  // namespace sandgraph::dem
