#pragma once
#include <string>
#include <vector>

#include "dem/fast/state.hpp"

// The inner loops of the fast DEM step, dispatched at run time to the widest instruction set of the machine.
// Equations: the YADE step of tests/data/yade/README, with the tangential force as a scalar in the contact's
// frame (exact rotation instead of YADE's first-order one: a difference of second order in the rotation a
// step).
namespace sandgraph::dem {

// Contact forces at the current positions: fills state.force, advances the contact history by dt.
// `moment_sum`, if given, receives sum over contacts of d (x) f as (xx, xy, yx, yy) [N m].
void contact_forces(FastState& state, const KernelConstants& k, double dt, double* moment_sum);

// Integrates velocities with the forces (local damping on the fluctuation velocity, convective term).
// Returns the largest fluctuation speed squared [m2/s2].
double kick(FastState& state, const KernelConstants& k, double dt);

// Kick, then the mean-field jump to the velocity gradient L and the move of grains and cell: one pass.
double kick_drift(FastState& state, const KernelConstants& k, const Mat2& L, double dt);

// The jump to L and the move alone.
double drift(FastState& state, const Mat2& L, double dt);

// Records of the working state from positions [2 N: x, y], velocities [3 N: vx, vy, spin] and radii [N], and
// back, rounding velocities to float.
void unpack_grains(const double* position, const float* velocity, const double* radius, int grains,
                   double* records);
void pack_grains(const double* records, int grains, double* position, float* velocity);

// Contact history, `count` a multiple of FastState::kLanes.
void widen(const float* from, int count, double* to);
void narrow(const double* from, int count, float* to);

std::string kernel_target();  // the instruction set in use, e.g. "AVX3"

// Those of the program that this machine can run, widest first.
std::vector<std::string> kernel_targets();

// Ties every dispatched loop of the program to one of them; throws std::invalid_argument for any other name.
// For comparison only: bits differ between instruction sets.
void use_kernel_target(const std::string& name);

}  // namespace sandgraph::dem
