#include "dem/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandgraph::dem {

// docs/how_it_works.md (eq. 24).
double critical_time_step(const Material& m, std::span<const double> radii) {
    const auto [smallest, largest] = std::ranges::minmax(radii);
    const double mass = m.density * m.depth * std::numbers::pi * smallest * smallest;
    const double k_n = m.young * 2 * smallest * largest / (smallest + largest);
    const double k_t = m.stiffness_ratio * k_n;
    // omega^2 of one contact: of a disk that moves, and of one that turns on the spot (I = m r^2/2) against
    // k_t r^2 + k_r, k_r = beta k_t r_i r_j; a neighbour that turns along doubles the slip.
    const double moves = (k_n + k_t) / mass;
    const double turns = 2 * k_t * (1 + std::max(1.0, m.rolling_stiffness * largest / smallest)) / mass;
    const double contacts = std::numbers::pi / std::asin(largest / (smallest + largest));
    return 2 / std::sqrt(contacts * std::max(moves, turns));
}

}  // namespace sandgraph::dem
