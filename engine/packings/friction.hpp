#pragma once
#include <string>

#include "base/console.hpp"
#include "dem/material.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::packings {

// Peak friction angle [rad] of a packing: biaxial tests at dem::confining_pressures (times the stiffness of
// the grains) to 10 % strain (Liang et al. 2021, Fig. 2), one line through the origin. Kept in the packing
// cache under `recipe`.
double measured_friction(const dem::Packing& packing, const dem::Material& material,
                         const std::string& recipe, const ProgressCallback& progress);

}  // namespace sandgraph::packings
