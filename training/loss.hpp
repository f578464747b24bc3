#pragma once
#include "scene/train_spec.hpp"
#include "training/law.hpp"

namespace sandgraph::training {

using scene::LossScale;

// |sigma - sigma_DEM| (Frobenius) / max(p_DEM, 1 kPa) of every member after every step [T, E, B].
torch::Tensor stress_error(const Prediction& prediction, const Batch& batch);

// The same of the ensemble's mean [T, B].
torch::Tensor ensemble_error(const Prediction& prediction, const Batch& batch);

// Mean over the weighted steps of each member's error, squared while small and linear beyond `robust`
// (pseudo- Huber), for past the peak two packings part like weather [E]. `drawn` [E, n] counts how often each
// member's bootstrap drew each history of the set.
torch::Tensor rollout_loss(const Prediction& prediction, const Batch& batch, const torch::Tensor& drawn,
                           const LossScale& scale);

}  // namespace sandgraph::training
