#pragma once
#include <numbers>

namespace sandgraph::dem {

// Grain contact parameters, Table 1 of Liang et al. (2021). Forces are those of disks `depth` thick [N].
enum class RollingForm { incremental, total };  // elastic-plastic increments | paper's eq. 10 read literally

struct Material {
    double density = 2650;         // grain density [kg/m3]
    double young = 800e6;          // E [Pa]; k_n = E r*, r* = 2 r_i r_j / (r_i + r_j)  [N/m]
    double stiffness_ratio = 0.5;  // k_t / k_n
    double friction_angle = 23.0 * std::numbers::pi / 180.0;  // [rad]
    double rolling_stiffness = 1.0;                           // beta: k_r = beta k_t r_i r_j  [N m]
    double rolling_limit = 0.05;                              // eta: |M| <= eta min(r_i, r_j) f_n
    double damping = 0.1;                                     // alpha, local damping
    double depth = 0.1;                                       // thickness of the disks and of the cell [m]
    RollingForm rolling_form = RollingForm::incremental;
};

}  // namespace sandgraph::dem
