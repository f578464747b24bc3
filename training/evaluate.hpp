#pragma once
#include "training/error_table.hpp"
#include "training/law.hpp"

namespace sandgraph::training {

// Errors of the ensemble's mean after every weighted step of the batches.
std::vector<ErrorSample> evaluate(const Law& law, std::span<const Batch> batches);

}  // namespace sandgraph::training
