#pragma once
#include "training/law.hpp"

namespace sandgraph::training {

// Constants of the packing as the baselines see them, of the order of one [B, 7]: ln p0, ln K0/p0, ln G0/p0,
// e0, Z0 and both parts of the initial deviator over p0.
torch::Tensor packing_input(const Batch& batch);
inline constexpr std::int64_t packing_inputs = 7;

// Stress from what a baseline's last layer says beyond what it says at rest [T, E, B, 3]: so it starts at the
// initial stress.
Prediction baseline_stress(const torch::Tensor& change, const Batch& batch);

}  // namespace sandgraph::training
