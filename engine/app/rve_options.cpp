#include "app/rve_options.hpp"

#include <cmath>
#include <numbers>

namespace sandgraph::app {

double critical_time_step(const dem::Material& m, double radius_min) {
    // m = rho h pi r^2 and k_n = E r* = E r for two equal disks.
    return std::sqrt(m.density * m.depth * std::numbers::pi * radius_min / m.young);
}

dem::RveOptions rve_options(const scene::RveStepping& stepping, const dem::Material& material,
                            double radius_min) {
    dem::RveOptions options;
    options.time_step = stepping.time_step_fraction * critical_time_step(material, radius_min);
    options.inertial_number_max = stepping.inertial_number_max;
    options.strain_per_step_max = stepping.strain_per_step_max;
    options.pressure_floor = stepping.pressure_floor;
    options.steps_min = stepping.steps_min;
    return options;
}

}  // namespace sandgraph::app
