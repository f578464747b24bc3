#include "scene/expected_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dem/grain_scale.hpp"

namespace sandgraph::scene {

double expected_density(const Scene& s) {
    const Grains& g = s.ground.grains;
    return s.ground.law == Law::rve ? g.material.density * (1 - g.target_porosity)
                                    : s.ground.continuum.density;
}

double expected_modulus(const Scene& s) {
    if (s.ground.law != Law::rve) return s.ground.continuum.elastic().p_wave();
    const Grains& g = s.ground.grains;
    constexpr double stiffer = 1.8;  // packings of Table 1 at 90 kPa, beside two grains
    return stiffer * dem::grain_scale(std::array{g.radius_min, g.radius_max}, g.material).modulus;
}

double default_pull_rate(const Scene& s) {  // docs/how_it_works.md (eq. 13a)
    constexpr double fastest = 0.05, pressure_share = 0.25, crossing_travel = 0.0015;
    const double inertia = expected_density(s) * s.mpm.mass_scaling;
    const double c = std::sqrt(expected_modulus(s) / inertia), H = s.anchor.embedment_ratio * s.anchor.width;
    const double pressure = expected_density(s) * s.ground.gravity * H + s.ground.surcharge;
    return std::min({fastest, pressure_share * pressure / (inertia * c),
                     crossing_travel * s.anchor.width * c / (H + s.anchor.width)});
}

}  // namespace sandgraph::scene
