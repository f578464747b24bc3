#include "training/loss.hpp"

#include <torch/types.h>

namespace sandgraph::training {
namespace {

using torch::Tensor;

constexpr double p_scale_least = 1e3;  // [Pa]

Tensor scaled_difference(const Tensor& p, const Tensor& s, const Tensor& p_measured,
                         const Tensor& s_measured) {
    const Tensor squared = 2 * (p - p_measured).square() + 2 * (s - s_measured).square().sum(-1);
    return torch::sqrt(squared + 1e-12) / p_measured.clamp_min(p_scale_least);
}

}  // namespace

Tensor stress_error(const Prediction& prediction, const Batch& batch) {
    return scaled_difference(prediction.p, prediction.s, batch.p.unsqueeze(1), batch.s.unsqueeze(1));
}

Tensor ensemble_error(const Prediction& prediction, const Batch& batch) {
    return scaled_difference(prediction.p.mean(1), prediction.s.mean(1), batch.p, batch.s);
}

Tensor rollout_loss(const Prediction& prediction, const Batch& batch, const Tensor& drawn, double robust) {
    const Tensor error = stress_error(prediction, batch) / robust;
    const Tensor loss = robust * robust * (torch::sqrt(1 + error.square()) - 1);
    const std::vector<std::int64_t> every = {0, 2};
    const Tensor weight = batch.weight.unsqueeze(1) * drawn.index_select(1, batch.histories).unsqueeze(0);
    return (weight * loss).sum(every) / weight.sum(every).clamp_min(1);
}

}  // namespace sandgraph::training
