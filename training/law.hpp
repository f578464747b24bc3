#pragma once
#include <torch/nn/module.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/train_spec.hpp"
#include "surrogate/model.hpp"
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

    // Only of laws that can be served; the others do nothing. Parameters and ranges of a served model (`file`
    // is named in the InputError when shapes differ); critical state held as measured; feature ranges as the
    // batches show them, or wider; the law as plain numbers, `substep` the largest strain of its integration.
    virtual void start_from(const surrogate::Model&, const std::string& file);
    virtual void hold_critical_state() {}
    virtual void learn_ranges(std::span<const Batch>) {}
    virtual std::optional<surrogate::Model> served(double substep) const;
};

using Rung = scene::TrainRung;
inline constexpr std::array rungs = {Rung::elastic, Rung::fitted, Rung::learned, Rung::mlp, Rung::gru};
const char* name_of(Rung rung);

// Initial weights of a layer [E, in, out]: normal, standard deviation gain/sqrt(in).
torch::Tensor layer_weights(std::int64_t members, std::int64_t in, std::int64_t out, double gain);

}  // namespace sandgraph::training
