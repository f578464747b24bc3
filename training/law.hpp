#pragma once
#include <torch/nn/module.h>

#include <array>
#include <string>
#include <vector>

#include "scene/train_spec.hpp"
#include "training/batch.hpp"

namespace sandgraph::training {

// What E members answer to a batch, each rolled out from rest by itself.
struct Prediction {
    torch::Tensor p;     // [T, E, B] after each step [Pa]
    torch::Tensor s;     // [T, E, B, 2]
    torch::Tensor slip;  // [T, E, B] accumulated plastic shear; of the elements only
};

// A stress law with parameters to be trained; all members at once, each parameter with the member first.
class Law : public torch::nn::Module {
  public:
    virtual Prediction rollout(const Batch& batch) const = 0;
    virtual std::int64_t members() const = 0;
};

using Rung = scene::TrainRung;
inline constexpr std::array rungs = {Rung::elastic, Rung::fitted, Rung::learned, Rung::mlp, Rung::gru};
const char* name_of(Rung rung);

// Initial weights of a layer [E, in, out]: normal, standard deviation gain/sqrt(in).
torch::Tensor layer_weights(std::int64_t members, std::int64_t in, std::int64_t out, double gain);

}  // namespace sandgraph::training
