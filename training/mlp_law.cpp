#include "training/mlp_law.hpp"

#include <torch/types.h>

#include <array>

#include "training/baseline_input.hpp"

namespace sandgraph::training {
namespace {

using torch::Tensor;

constexpr std::array memory_lengths = {1e-4, 1e-3, 1e-2};  // strain over which the past fades
constexpr std::int64_t hidden = 64, history_inputs = 3 * (1 + memory_lengths.size()) + 2;

// Large and small strains both within reach of a network: sign(x) ln(1 + |x|/unit).
Tensor squeezed(const Tensor& x, double unit) { return x.sign() * torch::log1p(x.abs() / unit) / 3; }

Tensor strain_steps(const Batch& batch) { return torch::cat({batch.dv.unsqueeze(2), batch.de}, 2); }

// Sum of the steps, each fading with the path gone since [T, B, 3].
Tensor faded(const Batch& batch, double length) {
    const Tensor steps = strain_steps(batch), size = steps.square().sum(2, true).sqrt();
    Tensor memory = torch::zeros_like(steps[0]);
    std::vector<Tensor> all;
    for (std::int64_t t = 0; t < batch.steps(); ++t)
        all.push_back(memory = memory * torch::exp(-size[t] / length) + steps[t]);
    return torch::stack(all);
}

// [T, B, history_inputs + packing_inputs]
Tensor input(const Batch& batch) {
    std::vector<Tensor> x = {squeezed(strain_steps(batch).cumsum(0), 1e-4)};
    for (const double length : memory_lengths) x.push_back(squeezed(faded(batch, length), 0.1 * length));
    x.push_back(squeezed(batch.strain, 1e-4).unsqueeze(2));
    x.push_back((((1 + batch.e0) * batch.J - 1 - 0.22) / 0.04).unsqueeze(2));
    x.push_back(packing_input(batch).expand({batch.steps(), -1, -1}));
    return torch::cat(x, 2);
}

// The same at rest [1, B, ...].
Tensor rest_input(const Batch& batch) {
    const std::int64_t B = batch.size();
    const Tensor still = torch::zeros({1, B, history_inputs - 1}, batch.dv.options());
    const Tensor e = ((batch.e0 - 0.22) / 0.04).reshape({1, B, 1});
    return torch::cat({still, e, packing_input(batch).unsqueeze(0)}, 2);
}

}  // namespace

MlpLaw::MlpLaw(std::int64_t members, std::uint64_t seed) {
    torch::manual_seed(seed);
    constexpr std::int64_t in = history_inputs + packing_inputs;
    const auto layer = [&](const char* name, std::int64_t from, std::int64_t to, double gain) {
        return register_parameter(name, layer_weights(members, from, to, gain));
    };
    W1 = layer("W1", in, hidden, 1), W2 = layer("W2", hidden, hidden, 1), W3 = layer("W3", hidden, 3, 0.1);
    b1 = register_parameter("b1", torch::zeros({members, 1, hidden}, torch::kDouble));
    b2 = register_parameter("b2", torch::zeros({members, 1, hidden}, torch::kDouble));
}

Tensor MlpLaw::answer(const Tensor& x) const {
    const Tensor flat = x.flatten(0, 1).expand({members(), -1, -1});
    const Tensor h = torch::tanh(torch::baddbmm(b2, torch::tanh(torch::baddbmm(b1, flat, W1)), W2));
    return torch::bmm(h, W3).reshape({members(), x.size(0), x.size(1), 3}).transpose(0, 1);
}

Prediction MlpLaw::rollout(const Batch& batch) const {
    return baseline_stress(answer(input(batch)) - answer(rest_input(batch)), batch);
}

}  // namespace sandgraph::training
