#pragma once
#include <numbers>

namespace sandgraph::stress {

// Isotropic linear elasticity from Young's modulus [Pa] and Poisson's ratio.
struct ElasticConstants {
    double young = 0, poisson = 0;
    double shear() const { return young / (2 * (1 + poisson)); }                           // G
    double lame() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }  // lambda
    double p_wave() const { return lame() + 2 * shear(); }                                 // M
};

// Of the Mohr-Coulomb law; the scene's keys [continuum] bind to these members.
struct MohrCoulombConstants {
    double young = 20e6, poisson = 0.3;                                       // [Pa], -
    double friction_angle = 30 * std::numbers::pi / 180, dilation_angle = 0;  // phi, psi [rad]
    double cohesion = 0;                                                      // c [Pa]
    ElasticConstants elastic() const { return {young, poisson}; }
};

}  // namespace sandgraph::stress
