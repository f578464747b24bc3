#include "training/gru_law.hpp"

#include <torch/types.h>

#include "training/baseline_input.hpp"

namespace sandgraph::training {
namespace {

using torch::Tensor;

constexpr std::int64_t hidden = 32, in = 3 + packing_inputs;
constexpr double strain_unit = 2e-4;

// [T, B, in]
Tensor input(const Batch& batch) {
    const Tensor strain = torch::cat({batch.dv.unsqueeze(2), batch.de}, 2) / strain_unit;
    return torch::cat({strain, packing_input(batch).expand({batch.steps(), -1, -1})}, 2);
}

}  // namespace

GruLaw::GruLaw(std::int64_t members, std::uint64_t seed) {
    torch::manual_seed(seed);
    W = register_parameter("W", layer_weights(members, in, 3 * hidden, 1));
    U = register_parameter("U", layer_weights(members, hidden, 3 * hidden, 1));
    V = register_parameter("V", layer_weights(members, hidden, 3, 0.1));
    b = register_parameter("b", torch::zeros({members, 1, 3 * hidden}, torch::kDouble));
}

Prediction GruLaw::rollout(const Batch& batch) const {
    const std::int64_t E = members(), T = batch.steps(), B = batch.size();
    const Tensor flat = input(batch).flatten(0, 1).expand({E, -1, -1});
    const Tensor driven = torch::baddbmm(b, flat, W).reshape({E, T, B, 3 * hidden}).transpose(0, 1);
    Tensor h = torch::zeros({E, B, hidden}, batch.dv.options());
    std::vector<Tensor> states;
    for (std::int64_t t = 0; t < T; ++t) {
        const Tensor recurrent = torch::bmm(h, U), x = driven[t];
        const Tensor gates = torch::sigmoid(x.narrow(2, 0, 2 * hidden) + recurrent.narrow(2, 0, 2 * hidden));
        const Tensor keep = gates.narrow(2, hidden, hidden);
        const Tensor fresh =
            torch::tanh(x.narrow(2, 2 * hidden, hidden) +
                        gates.narrow(2, 0, hidden) * recurrent.narrow(2, 2 * hidden, hidden));
        states.push_back(h = keep * h + (1 - keep) * fresh);
    }
    return baseline_stress(torch::matmul(torch::stack(states), V), batch);
}

}  // namespace sandgraph::training
