#include "training/baselines.hpp"

#include <torch/types.h>

#include <array>

#include "training/element_law.hpp"

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

constexpr std::int64_t gru_hidden = 32, gru_inputs = 3 + packing_inputs;
constexpr double strain_unit = 2e-4;

// [T, B, gru_inputs]
Tensor gru_input(const Batch& batch) {
    const Tensor strain = torch::cat({batch.dv.unsqueeze(2), batch.de}, 2) / strain_unit;
    return torch::cat({strain, packing_input(batch).expand({batch.steps(), -1, -1})}, 2);
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

GruLaw::GruLaw(std::int64_t members, std::uint64_t seed) {
    torch::manual_seed(seed);
    W = register_parameter("W", layer_weights(members, gru_inputs, 3 * gru_hidden, 1));
    U = register_parameter("U", layer_weights(members, gru_hidden, 3 * gru_hidden, 1));
    V = register_parameter("V", layer_weights(members, gru_hidden, 3, 0.1));
    b = register_parameter("b", torch::zeros({members, 1, 3 * gru_hidden}, torch::kDouble));
}

Prediction GruLaw::rollout(const Batch& batch) const {
    const std::int64_t E = members(), T = batch.steps(), B = batch.size();
    const Tensor flat = gru_input(batch).flatten(0, 1).expand({E, -1, -1});
    const Tensor driven = torch::baddbmm(b, flat, W).reshape({E, T, B, 3 * gru_hidden}).transpose(0, 1);
    Tensor h = torch::zeros({E, B, gru_hidden}, batch.dv.options());
    std::vector<Tensor> states;
    for (std::int64_t t = 0; t < T; ++t) {
        const Tensor recurrent = torch::bmm(h, U), x = driven[t];
        const Tensor gates =
            torch::sigmoid(x.narrow(2, 0, 2 * gru_hidden) + recurrent.narrow(2, 0, 2 * gru_hidden));
        const Tensor keep = gates.narrow(2, gru_hidden, gru_hidden);
        const Tensor fresh =
            torch::tanh(x.narrow(2, 2 * gru_hidden, gru_hidden) +
                        gates.narrow(2, 0, gru_hidden) * recurrent.narrow(2, 2 * gru_hidden, gru_hidden));
        states.push_back(h = keep * h + (1 - keep) * fresh);
    }
    return baseline_stress(torch::matmul(torch::stack(states), V), batch);
}

Tensor packing_input(const Batch& batch) {
    return torch::stack(
        {(batch.p0 / 10e3).log() / 3, ((batch.K0 / batch.p0).log() - 6) / 2,
         ((batch.G0 / batch.p0).log() - 6) / 2, (batch.e0 - 0.22) / 0.04, (batch.Z0 - 3.5) / 0.5,
         batch.s0.select(1, 0) / batch.p0, batch.s0.select(1, 1) / batch.p0},
        1);
}

// The mean stress by its logarithm, so that it stays positive; the deviator as a share of it.
Prediction baseline_stress(const Tensor& change, const Batch& batch) {
    const Tensor p = batch.p0 * change.select(3, 0).clamp(-6, 6).exp();
    const Tensor ratio = (batch.s0 / batch.p0.unsqueeze(1)) + change.narrow(3, 1, 2);
    return {p, p.unsqueeze(3) * ratio, {}};
}

std::shared_ptr<Law> make_law(Rung rung, std::int64_t members, std::uint64_t seed, torch::Dtype type) {
    std::shared_ptr<Law> law;
    if (rung == Rung::mlp)
        law = std::make_shared<MlpLaw>(members, seed);
    else if (rung == Rung::gru)
        law = std::make_shared<GruLaw>(members, seed);
    else
        law = std::make_shared<ElementLaw>(rung, members, seed);
    law->to(type);
    return law;
}

}  // namespace sandgraph::training
