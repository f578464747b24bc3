#pragma once
#include <cmath>
#include <string>

#include "base/archive.hpp"
#include "base/contracts.hpp"
#include "base/tensor.hpp"
#include "mpm/enrichment.hpp"
#include "mpm/rectangle.hpp"

namespace sandgraph::mpm {

// Pressure of the ground on the plate at rest, linear with depth [Pa], compression positive. The plate's
// faces are moved out by p0/k_a, so that the pull starts from equilibrium.
struct RestPressure {
    double vertical = 0, horizontal = 0;                    // at the plate's centre [Pa]
    double vertical_gradient = 0, horizontal_gradient = 0;  // d/d(depth) [Pa/m]
};

// That of ground at rest on a body whose centre lies `depth` [m] under the surface: vertical
// surcharge + unit_weight depth [Pa], horizontal K0 of it.
inline RestPressure rest_pressure(double surcharge, double unit_weight, double depth, double K0 = 1) {
    const double vertical = surcharge + unit_weight * depth;
    return {vertical, K0 * vertical, unit_weight, K0 * unit_weight};
}

// A rigid rectangle, or a circle, with prescribed velocity, per metre out of plane.
struct RigidPlate {
    double x = 0, y = 0;                     // centre [m]
    double half_width = 0, half_height = 0;  // [m]
    Vec2 velocity = Vec2::Zero();            // [m/s]
    double friction_angle = 0;               // plate-soil [rad]; pi/2: perfectly rough
    double stiffness = 0;                    // k_a [Pa/m]: pressure per penetration
    RestPressure rest = {};
    bool round = false;  // a circle of radius half_width
    // Nodes beyond the ends of a face are not pressed: where the ends lie between nodes (contact_point.hpp).
    bool trimmed = true;

    // Of a circle's edge, outside positive [m].
    double distance(double px, double py) const { return std::hypot(px - x, py - y) - half_width; }
    // About all of it.
    Rectangle rectangle() const { return {x - half_width, y - half_height, x + half_width, y + half_height}; }
};

// k_a = factor M / cell [Pa/m], M: P-wave modulus of the ground [Pa].
inline double contact_stiffness(double factor, double p_wave_modulus, double cell) {
    SG_EXPECT(factor > 0 && p_wave_modulus > 0 && cell > 0);
    return factor * p_wave_modulus / cell;
}

// The mid-plane along the plate's long side.
Enrichment enrichment_of(const RigidPlate& plate);

// Moves the centre by dt velocity.
void advance(RigidPlate& plate, double dt);
void archive(Archive& a, RigidPlate& plate, const std::string& prefix = "");

}  // namespace sandgraph::mpm
