#pragma once
#include <optional>
#include <span>

#include "scene/scene.hpp"

// Limit loads of dry, cohesionless, associated Mohr-Coulomb ground in plane strain that are known exactly.
namespace sandgraph::results {

// Strip footing on weighty sand, q_u = gamma B N_gamma / 2: method of characteristics (values as Martin
// 2005), between their angles by a cubic in the logarithm; NaN outside of 5 to 45 deg.
double footing_factor(double friction_angle, bool rough);

// Strip footing under a surcharge on weightless sand, q_u = q N_q (Prandtl, Reissner).
double surcharge_factor(double friction_angle);

// Rankine: smooth vertical wall, E = K gamma H^2 / 2.
double passive_factor(double friction_angle);
double active_factor(double friction_angle);

// Plate or trapdoor pulled up, N = Q / (gamma H B) = 1 + (H/B) tan(phi).
double uplift_factor(double embedment_ratio, double friction_angle);

// What the scene's exact case is told in, the load over `unit` [N/m], and its exact value (NaN: not known).
struct ExactLoad {
    double factor = 0, unit = 1;
};
std::optional<ExactLoad> exact_load(const scene::Scene& scene, double density);

// Where the curve has become level: its mean over the last fifth of the displacement.
double limit_load(std::span<const double> d_over_B, std::span<const double> load);

}  // namespace sandgraph::results
