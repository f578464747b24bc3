#pragma once
#include "scene/scene.hpp"

// What is known of a scene's ground before anything of it is made.
namespace sandgraph::scene {

double expected_density(const Scene& scene);  // bulk [kg/m3]

// P-wave modulus [Pa]; packings: of the order.
double expected_modulus(const Scene& scene);

// The rate of an anchor whose scene gives none [m/s]: 0.05 m/s, the paper's, or slower, so that the pressure
// rho c v of the wave that the plate sends out stays below 0.25 of that on the plate, and so that the plate
// moves by less than 0.0015 B while a wave crosses the ground above it. Damping, PIC and inertia then carry
// less than 2 % of the load (tests/bench/drag_scenes.py).
double default_pull_rate(const Scene& scene);

}  // namespace sandgraph::scene
