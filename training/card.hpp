#pragma once
#include "training/error_table.hpp"
#include "training/session.hpp"
#include "training/verdict.hpp"

namespace sandgraph::training {

// The model card, JSON: what the model was trained on, its ranges, its errors by regime on held-out histories
// beside the noise floor, whether it is better than the model it started from, and how to make it again.
std::string model_card(const scene::TrainSpec& spec, const TrainingData& data, const Trained& trained,
                       std::span<const ErrorTable> tables, const Verdict& verdict, const std::string& command,
                       const std::string& revision);

}  // namespace sandgraph::training
