#include "dem/rve_options.hpp"

#include "dem/element_test/element_test.hpp"
#include "dem/time_step.hpp"

namespace sandgraph::dem {

RveOptions rve_options(const RveStepping& stepping, const Material& material, std::span<const double> radii) {
    RveOptions options{stepping};
    options.time_step = stepping.time_step_fraction * critical_time_step(material, radii);
    options.modulus = typical_modulus(radii, material);
    return options;
}

}  // namespace sandgraph::dem
