#pragma once
#include "training/error_table.hpp"
#include "training/law.hpp"
#include "training/path.hpp"

namespace sandgraph::training {

// Errors of the ensemble's mean after every weighted step of the batches.
std::vector<ErrorSample> evaluate(const Law& law, std::span<const Batch> batches);

// How far apart DEM itself lies: the answers of a twin against those of its original, by kind of twin
// (another packing seed, a turned path, a path cut finer or coarser). No law can be expected below.
std::vector<ErrorTable> noise_floor(const HistorySet& set, const CutRule& rule, double strain_max);

}  // namespace sandgraph::training
