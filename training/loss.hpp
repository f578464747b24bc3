#pragma once
#include "training/law.hpp"

namespace sandgraph::training {

// |sigma - sigma_DEM| (Frobenius) / max(p_DEM, 1 kPa) of every member after every step [T, E, B].
torch::Tensor stress_error(const Prediction& prediction, const Batch& batch);

// The same of the ensemble's mean [T, B].
torch::Tensor ensemble_error(const Prediction& prediction, const Batch& batch);

struct LossScale {
    double robust = 0.1;  // error beyond which the loss grows linearly
    // While the measured stress has moved by less than this share of p since the start, the error counts as a
    // share of that way: stiffness at small strain carries a foundation long before anything fails. 0: never.
    double change = 0;
    // Deviators are compared as shares of the answer's and of the measured p. What sand bears at given strain
    // is strength times a pressure that is weather: an answer whose p is low must not make up for it by
    // friction, which the ground then has at any p.
    bool friction = false;
};

// Mean over the weighted steps of each member's error, squared while small and linear beyond `robust`
// (pseudo- Huber), for past the peak two packings part like weather [E]. `drawn` [E, n] counts how often each
// member's bootstrap drew each history of the set.
torch::Tensor rollout_loss(const Prediction& prediction, const Batch& batch, const torch::Tensor& drawn,
                           const LossScale& scale);

}  // namespace sandgraph::training
