#pragma once
#include <array>

#include "stress/constants.hpp"

namespace sandgraph::stress {

// Principal stresses [Pa], tension positive, s1 >= s2 >= s3.
using Principal = std::array<double, 3>;

// Perfectly plastic Mohr-Coulomb, non-associated: yield (s1 - s3) + (s1 + s3) sin phi - 2 c cos phi = 0, flow
// with psi in place of phi; isotropic elasticity. Exact implicit return to the main plane, an edge or the
// apex (de Souza Neto, Peric & Owen 2008, section 8.2, without hardening).
Principal return_to_yield(const Principal& trial, const MohrCoulombConstants& constants);

// (s1 - s3) + (s1 + s3) sin phi - 2 c cos phi [Pa]; <= 0 inside.
double yield(double s1, double s3, const MohrCoulombConstants& constants);

}  // namespace sandgraph::stress
