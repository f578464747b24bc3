#pragma once
#include "mpm/contact.hpp"
#include "mpm/points.hpp"

// Sums over all points in id order: the same bits at any thread count. Per metre out of plane.
namespace sandgraph::mpm {

double total_mass(const Points& points);        // [kg/m]
Vec2 momentum(const Points& points);            // sum m v [kg/s]
double angular_momentum(const Points& points);  // sum m (x v_y - y v_x) about the origin [kg m/s]
double kinetic_energy(const Points& points, double mass_scaling = 1);  // sum s m v^2 / 2 [J/m]
double gravity_potential(const Points& points, const Vec2& gravity);   // -sum m g . x [J/m]

// sum V sigma : (F_inc - I) [J/m], with the stress as it stands. Mid-step work of one step: half of this
// before the material law plus half of it after.
double stress_work(const Points& points);

// Work of the plate on the soil in one step [J/m]: -(reaction . v) dt.
double plate_work(const RigidPlate& plate, const Reaction& reaction, double dt);

}  // namespace sandgraph::mpm
