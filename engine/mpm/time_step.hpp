#pragma once
#include <algorithm>
#include <cmath>

namespace sandgraph::mpm {

struct StepLimits {
    double courant = 0.3;
    double cell = 0;            // [m]
    double p_wave_modulus = 0;  // M [Pa]
    double density = 0;         // [kg/m3]
    double mass_scaling = 1;
    double contact_stiffness = 0;  // of the plate, in units of M/cell
};

// dt = courant cell / c with c = sqrt(M / (s rho)) [s]. The plate's penalty on the lightest node beside it
// adds 4 kappa to (omega cell / c)^2 of the grid, 4. The bound keeps dt omega at 0.9: undamped ground stays
// bounded over 10,000 steps at 0.95 and gains energy at 1 (tests/stability, step.limit).
inline double time_step(const StepLimits& l) {
    const double crossing = l.cell * std::sqrt(l.density * l.mass_scaling / l.p_wave_modulus);
    return crossing * std::min(l.courant, 0.45 / std::sqrt(1 + l.contact_stiffness));
}

}  // namespace sandgraph::mpm
