#include "training/element_law.hpp"

#include <torch/types.h>
#include <torch/utils.h>

#include <cmath>

namespace sandgraph::training {
namespace {

using torch::Tensor;

constexpr double bound = 3;  // of every factor the network sets, both ways

}  // namespace

ElementLaw::ElementLaw(Rung rung, std::int64_t members, std::uint64_t seed) : rung_(rung) {
    torch::manual_seed(seed);
    const bool slips = rung != Rung::elastic, net = rung == Rung::learned;
    const auto make = [&](const char* name, const Tensor& value, bool trained) {
        return register_parameter(name, value.to(torch::kDouble), trained);
    };
    const auto scatter = [&](double size, torch::IntArrayRef shape) {
        return size * torch::randn(shape, torch::kDouble);
    };
    const Tensor yield = torch::linspace(std::log(1e-5), std::log(1e-2), elements, torch::kDouble);
    exponent = make("exponent", -2 + scatter(0.2, {members}), true);
    log_bulk = make("log_bulk", scatter(0.05, {members}), true);
    const surrogate::CriticalState c;
    critical =
        make("critical",
             torch::tensor({std::log(c.mature), std::log(c.pull), c.void_ratio / 0.04, std::log(c.slope)},
                           torch::kDouble) +
                 scatter(0.05, {members, 4}),
             slips);
    share = make("share", -yield + scatter(0.2, {members, elements}), slips);
    log_strength = make("log_strength", std::log(0.45 / elements) + scatter(0.2, {members, elements}), slips);
    dilatancy = make("dilatancy", 0.1 + scatter(0.05, {members, elements}), slips);
    W1 = make("W1", layer_weights(members, features, hidden, 1), net);
    b1 = make("b1", scatter(0.1, {members, 1, hidden}), net);
    W2 = make("W2", layer_weights(members, hidden, hidden, 1), net);
    b2 = make("b2", scatter(0.1, {members, 1, hidden}), net);
    W3 = make("W3", layer_weights(members, hidden, outputs, 0.1), net);
    b3 = make("b3", torch::zeros({members, 1, outputs}), net);
    low = register_buffer("low", torch::full(features, -4.0, torch::kDouble));
    high = register_buffer("high", torch::full(features, 4.0, torch::kDouble));
}

Tensor ElementLaw::output_bias() const {
    const Tensor shift = torch::full({members(), 1, elements}, -std::log(bound), exponent.options());
    const Tensor offset = torch::cat({shift, shift, dilatancy.unsqueeze(1), shift.narrow(2, 0, 1)}, 2);
    return rung_ == Rung::learned ? b3 + offset : offset;
}

// Kept where a packing of grains can be: a member that sees little flow must not wander off.
Tensor ElementLaw::critical_state() const {
    const auto column = [&](std::int64_t i) { return critical.narrow(1, i, 1); };
    Tensor void_ratio = 0.04 * column(2), slope = column(3).exp().clamp(1e-4, 0.05);
    if (measured_critical) {
        const surrogate::CriticalState measured;
        void_ratio = torch::full_like(void_ratio, measured.void_ratio);
        slope = torch::full_like(slope, measured.slope);
    }
    return torch::cat({column(0).exp().clamp(0.01, 1), column(1).exp().clamp(0.05, 5), void_ratio, slope}, 1);
}

std::vector<Tensor> ElementLaw::constants() const {
    constexpr double never_slips = 1e9;
    const Tensor w = torch::softmax(share, 1);
    const Tensor strength = rung_ == Rung::elastic ? never_slips * w : log_strength.exp();
    return {torch::sigmoid(exponent).unsqueeze(1),
            log_bulk.exp().unsqueeze(1),
            critical_state(),
            w,
            strength,
            W1,
            b1,
            W2,
            b2,
            W3,
            output_bias()};
}

}  // namespace sandgraph::training
