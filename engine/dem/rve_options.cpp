#include "dem/rve_options.hpp"

#include "dem/grain_scale.hpp"
#include "dem/time_step.hpp"

namespace sandgraph::dem {

RveOptions rve_options(const RveStepping& stepping, const Material& material, std::span<const double> radii) {
    RveOptions options{stepping};
    options.time_step = stepping.time_step_fraction * critical_time_step(material, radii);
    const GrainScale grains = grain_scale(radii, material);
    options.modulus = grains.modulus;
    options.float_pressure *= grains.stiffness;
    return options;
}

}  // namespace sandgraph::dem
