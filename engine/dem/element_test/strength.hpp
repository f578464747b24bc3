#pragma once
#include <array>
#include <span>

#include "dem/element_test/element_test.hpp"

namespace sandgraph::dem {

// The published programme (Liang et al. 2021, Fig. 2): three confining pressures [Pa], the peak within this
// axial strain.
inline constexpr std::array<double, 3> confining_pressures = {32e3, 64e3, 128e3};
inline constexpr double peak_strain = 0.1;

// The largest mobilised friction of a biaxial test up to `strain`: where it was and the angle asin(q/p)
// [rad].
struct PeakStrength {
    double axial_strain = 0;
    double p = 0, q = 0;  // [Pa]
    double friction_angle = 0;
};
PeakStrength peak_strength(std::span<const BiaxialRow> rows, double strain = peak_strain);

// One line q = p sin(phi) through the origin, least squares over the peaks of several pressures [rad].
double friction_angle(std::span<const PeakStrength> peaks);

}  // namespace sandgraph::dem
