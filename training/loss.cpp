#include "training/loss.hpp"

#include <torch/types.h>

#include "base/contracts.hpp"

namespace sandgraph::training {
namespace {

using torch::Tensor;

constexpr double p_scale_least = 1e3;  // [Pa]
constexpr double change_least = 0.05;  // noise of a step is not blown up beyond this

Tensor scaled_difference(const Tensor& p, const Tensor& s, const Tensor& p_measured,
                         const Tensor& s_measured) {
    const Tensor squared = 2 * (p - p_measured).square() + 2 * (s - s_measured).square().sum(-1);
    return torch::sqrt(squared + 1e-12) / p_measured.clamp_min(p_scale_least);
}

// The deviator as it would be at the measured p.
Tensor friction_error(const Prediction& prediction, const Batch& batch) {
    const Tensor measured = batch.p.unsqueeze(1);
    const Tensor to_measured = (measured / prediction.p).clamp(0.1, 10).unsqueeze(3);
    return scaled_difference(prediction.p, prediction.s * to_measured, measured, batch.s.unsqueeze(1));
}

// Largest way of the measured stress so far over `change` p, between change_least and 1 [T, 1, B].
Tensor share_of_change(const Batch& batch, double change) {
    if (change <= 0) return torch::ones({1, 1, 1}, batch.p.options());
    const Tensor way = scaled_difference(batch.p0, batch.s0, batch.p, batch.s);
    return (std::get<0>(way.cummax(0)) / change).clamp(change_least, 1).unsqueeze(1);
}

}  // namespace

Tensor stress_error(const Prediction& prediction, const Batch& batch) {
    return scaled_difference(prediction.p, prediction.s, batch.p.unsqueeze(1), batch.s.unsqueeze(1));
}

Tensor ensemble_error(const Prediction& prediction, const Batch& batch) {
    return scaled_difference(prediction.p.mean(1), prediction.s.mean(1), batch.p, batch.s);
}

Tensor rollout_loss(const Prediction& prediction, const Batch& batch, const Tensor& drawn,
                    const LossScale& scale) {
    const double robust = scale.robust;
    SG_EXPECT(robust > 0 && drawn.dim() == 2 && prediction.p.dim() == 3);
    const Tensor raw = scale.friction ? friction_error(prediction, batch) : stress_error(prediction, batch);
    const Tensor error = raw / (robust * share_of_change(batch, scale.change));
    const Tensor loss = robust * robust * (torch::sqrt(1 + error.square()) - 1);
    const std::vector<std::int64_t> every = {0, 2};
    const Tensor weight = batch.weight.unsqueeze(1) * drawn.index_select(1, batch.histories).unsqueeze(0);
    return (weight * loss).sum(every) / weight.sum(every).clamp_min(1);
}

}  // namespace sandgraph::training
