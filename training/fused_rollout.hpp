#pragma once
#include "training/element_law.hpp"

namespace sandgraph::training {

// ElementLaw::rollout with the coefficients of a step's beginning as one operation of torch. The gradient
// takes the loading of the elements at the start as given (zero where the start is isotropic).
Prediction roll_out_fused(const ElementLaw& law, const Batch& batch);

}  // namespace sandgraph::training
