#pragma once
#include <span>

#include "dem/element_test/element_test.hpp"

namespace sandgraph::dem {

// The largest mobilised friction of a biaxial test up to `strain`: where it was and the angle asin(q/p)
// [rad].
struct PeakStrength {
    double axial_strain = 0;
    double p = 0, q = 0;  // [Pa]
    double friction_angle = 0;
};
PeakStrength peak_strength(std::span<const BiaxialRow> rows, double strain = 0.1);

// One line q = p sin(phi) through the origin, least squares over the peaks of several pressures [rad].
double friction_angle(std::span<const PeakStrength> peaks);

}  // namespace sandgraph::dem
