#pragma once
#include <array>

namespace sandgraph::stress {

struct MohrCoulombConstants {
    double young = 0, poisson = 0;
    double friction_angle = 0, dilation_angle = 0;  // phi, psi [rad]
    double cohesion = 0;                            // c [Pa]
};

// Principal stresses [Pa], tension positive, s1 >= s2 >= s3.
using Principal = std::array<double, 3>;

// Perfectly plastic Mohr-Coulomb, non-associated: yield (s1 - s3) + (s1 + s3) sin phi - 2 c cos phi = 0, flow
// with psi in place of phi; isotropic elasticity. Exact implicit return to the main plane, an edge or the
// apex (de Souza Neto, Peric & Owen 2008, section 8.2, without hardening).
Principal return_to_yield(const Principal& trial, const MohrCoulombConstants& constants);

// (s1 - s3) + (s1 + s3) sin phi - 2 c cos phi [Pa]; <= 0 inside.
double yield(double s1, double s3, const MohrCoulombConstants& constants);

}  // namespace sandgraph::stress
