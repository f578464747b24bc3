#pragma once
#include <span>
#include <vector>

#include "dem/packing/observables.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// One contact at a force evaluation. n points from i to j; forces and moment act on j.
struct ContactForce {
    std::int32_t i = 0, j = 0;
    std::int16_t cell_x = 0, cell_y = 0;  // image of j: x_j + H (cell_x, cell_y)
    Vec2 n = Vec2::Zero();
    Vec2 f_t = Vec2::Zero();     // tangential force [N]
    double f_n = 0, moment = 0;  // normal force [N], rolling moment [N m]
    double overlap = 0;          // [m]
};

// The contacts a packing has as it lies: normal forces from the overlaps, tangential forces and moments from
// its history. Sorted by (i, j, cell).
std::vector<ContactForce> contact_forces(const Packing& packing, const Material& material);

// Love-Weber stress sigma_ab = (1/(A h)) sum_c d_a f_b [Pa], compression positive; d from i to j, f on j.
Mat2 love_weber_stress(const Packing& packing, std::span<const ContactForce> contacts,
                       const Material& material);

// Everything in Observables. H, radii, velocities and L are taken from `packing` (empty velocities: at rest).
Observables observe(const Packing& packing, std::span<const ContactForce> contacts, const Material& material);

}  // namespace sandgraph::dem
