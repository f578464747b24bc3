#pragma once
#include "base/tensor.hpp"

// Finite strain measures of a plane-strain deformation gradient F (2x2), F_zz = 1. NaN where det F <= 0.
namespace sandgraph::mpm {

// Logarithmic strain ln U with F = R U (2x2, extension positive), by the principal stretches of F^T F: exact
// for any rotation and any stretch.
Mat2 logarithmic_strain(const Mat2& F);

// eps_eq = sqrt(2/3 eps_q : eps_q), eps_q = ln U - tr(ln U)/3 I with eps_zz = 0 (Liang et al. 2021, Fig. 9).
double equivalent_strain(const Mat2& F);

// Angle of R in F = R U [rad], counter-clockwise positive, in (-pi, pi].
double rotation(const Mat2& F);

// ln det F, expansion positive.
double volumetric_strain(const Mat2& F);

}  // namespace sandgraph::mpm
