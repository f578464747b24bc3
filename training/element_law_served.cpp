#include "surrogate/model.hpp"
#include "training/element_law.hpp"

#include <fmt/format.h>
#include <torch/types.h>
#include <torch/utils.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace sandgraph::training {
namespace {

using torch::Tensor;

std::vector<double> numbers(const Tensor& tensor) {
    const Tensor plain = tensor.detach().to(torch::kDouble).contiguous().flatten();
    return {plain.data_ptr<double>(), plain.data_ptr<double>() + plain.numel()};
}

surrogate::Layer layer_of(const Tensor& weight, const Tensor& bias) {
    return {static_cast<std::size_t>(weight.size(0)), static_cast<std::size_t>(weight.size(1)),
            numbers(weight.t()), numbers(bias)};
}

surrogate::Member member_of(const ElementLaw& law, std::int64_t e) {
    surrogate::Member member;
    member.exponent = torch::sigmoid(law.exponent[e]).item<double>();
    member.bulk = law.log_bulk[e].exp().item<double>();
    const std::vector<double> c = numbers(law.critical_state()[e].to(torch::kDouble));
    member.critical = {c[0], c[1], c[2], c[3]};
    member.share = numbers(torch::softmax(law.share[e].to(torch::kDouble), 0));
    member.strength = numbers(law.log_strength[e].to(torch::kDouble).exp());
    member.dilatancy = numbers(law.dilatancy[e]);
    if (law.rung() == Rung::learned)
        member.layers = {layer_of(law.W1[e], law.b1[e]), layer_of(law.W2[e], law.b2[e]),
                         layer_of(law.W3[e], law.b3[e])};
    return member;
}

// Features of the rollout and of the measured state, weighted steps only [features, samples].
Tensor features_seen(const ElementLaw& law, const Batch& batch) {
    const Prediction rolled = law.rollout(batch);
    const auto all = [&](const Tensor& t) { return t.unsqueeze(1).expand_as(rolled.p); };
    const auto of_state = [&](const Tensor& p, const Tensor& s, const Tensor& slip) {
        const Tensor still = torch::zeros_like(p), eta = s.square().sum(3).sqrt() / p;
        const Tensor e = ((1 + batch.e0) * batch.J - 1 - 0.22) / 0.04;
        return torch::stack({(p / 1e4).log() / 3, all(e), (eta.square() + 1e-4).sqrt() / 0.4,
                             torch::log(1 + slip / 1e-3) / 3, still + (batch.p0 / 1e4).log() / 3,
                             still + (batch.e0 - 0.22) / 0.04, still + (batch.Z0 - 3.5) / 0.5,
                             still + (batch.sin_phi - 0.5) / 0.1, (s * batch.fabric).sum(3) / (0.1 * p)});
    };
    const Tensor p = batch.p.clamp_min(10).unsqueeze(1).expand_as(rolled.p);
    const Tensor s = batch.s.unsqueeze(1).expand_as(rolled.s);
    const Tensor used = all(batch.weight) > 0;
    return torch::cat({of_state(rolled.p, rolled.s, rolled.slip).index({torch::indexing::Slice(), used}),
                       of_state(p, s, rolled.slip).index({torch::indexing::Slice(), used})},
                      1);
}

Tensor tensor_of(const std::vector<double>& values) { return torch::tensor(values, torch::kDouble); }

void set_layer(Tensor weight, Tensor bias, const surrogate::Layer& layer) {
    weight.copy_(tensor_of(layer.weight).reshape({bias.size(1), -1}).t());
    bias.copy_(tensor_of(layer.bias).unsqueeze(0));
}

void check_shape(const ElementLaw& law, const surrogate::Model& model, const std::string& file) {
    const auto fits = [](const surrogate::Member& m) {
        return m.layers.size() == 3 && m.layers[0].outputs == ElementLaw::hidden &&
               m.layers[1].outputs == ElementLaw::hidden;
    };
    if (std::ssize(model.members) == law.members() && model.elements == ElementLaw::elements &&
        std::ranges::all_of(model.members, fits))
        return;
    throw InputError({file}, fmt::format("{} members of {} elements", model.members.size(), model.elements),
                     fmt::format("training goes on from {} members of {} elements and two layers of {}",
                                 law.members(), ElementLaw::elements, ElementLaw::hidden),
                     "set model.members to that of the file, or train from drawn weights");
}

}  // namespace

void ElementLaw::learn_ranges(std::span<const Batch> batches) {
    const torch::NoGradGuard no_gradients;
    constexpr double outliers = 1e-3, margin = 0.02;
    std::vector<Tensor> seen;
    for (const Batch& batch : batches) seen.push_back(features_seen(*this, batch));
    const Tensor sorted = std::get<0>(torch::cat(seen, 1).sort(1));
    const auto last = sorted.size(1) - 1;
    const auto cut = static_cast<std::int64_t>(outliers * static_cast<double>(last));
    const Tensor first_seen = sorted.select(1, cut), last_seen = sorted.select(1, last - cut);
    const Tensor wider = margin * (last_seen - first_seen) + 1e-3;
    // What a law was trained on before stays known: the guard watches over that.
    low.copy_(ranged_ ? torch::minimum(low, first_seen - wider) : first_seen - wider);
    high.copy_(ranged_ ? torch::maximum(high, last_seen + wider) : last_seen + wider);
    ranged_ = true;
}

void ElementLaw::start_from(const surrogate::Model& model, const std::string& file) {
    const torch::NoGradGuard no_gradients;
    check_shape(*this, model, file);
    for (std::size_t k = 0; k < model.members.size(); ++k) {
        const auto e = static_cast<std::int64_t>(k);
        const surrogate::Member& m = model.members[k];
        exponent[e].fill_(std::log(m.exponent / (1 - m.exponent)));
        log_bulk[e].fill_(std::log(m.bulk));
        critical[e].copy_(tensor_of({std::log(m.critical.mature), std::log(m.critical.pull),
                                     m.critical.void_ratio / 0.04, std::log(m.critical.slope)}));
        share[e].copy_(tensor_of(m.share).log());
        log_strength[e].copy_(tensor_of(m.strength).log());
        dilatancy[e].copy_(tensor_of(m.dilatancy));
        set_layer(W1[e], b1[e], m.layers[0]);
        set_layer(W2[e], b2[e], m.layers[1]);
        set_layer(W3[e], b3[e], m.layers[2]);
    }
    for (std::size_t i = 0; i < model.ranges.size(); ++i) {
        low[static_cast<std::int64_t>(i)] = model.ranges[i].low;
        high[static_cast<std::int64_t>(i)] = model.ranges[i].high;
    }
    ranged_ = true;
}

std::optional<surrogate::Model> ElementLaw::served(double substep) const {
    surrogate::Model model;
    model.elements = ElementLaw::elements;
    model.frictional = rung_ != Rung::elastic;
    model.substep = substep;
    for (std::size_t i = 0; i < model.ranges.size(); ++i)
        model.ranges[i] = {low[static_cast<std::int64_t>(i)].item<double>(),
                           high[static_cast<std::int64_t>(i)].item<double>()};
    for (std::int64_t e = 0; e < members(); ++e) model.members.push_back(member_of(*this, e));
    return model;
}

}  // namespace sandgraph::training
