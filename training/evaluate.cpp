#include "training/evaluate.hpp"

#include <torch/types.h>
#include <torch/utils.h>

#include "training/loss.hpp"

namespace sandgraph::training {
namespace {

void add_samples(const Law& law, const Batch& batch, std::vector<ErrorSample>& samples) {
    const auto plain = [](const torch::Tensor& t) { return t.to(torch::kDouble).contiguous(); };
    const Prediction rolled = law.rollout(batch);
    const torch::Tensor scale = batch.p.clamp_min(1e3);
    const torch::Tensor error = plain(ensemble_error(rolled, batch)),
                        p = plain((rolled.p.mean(1) - batch.p) / scale),
                        q = plain((rolled.s.mean(1).norm(2, 2) - batch.s.norm(2, 2)) / scale);
    const torch::Tensor strain = plain(batch.strain), weight = plain(batch.weight);
    const auto e = error.accessor<double, 2>(), l = strain.accessor<double, 2>(),
               w = weight.accessor<double, 2>(), dp = p.accessor<double, 2>(), dq = q.accessor<double, 2>();
    const auto history = batch.histories.accessor<std::int64_t, 1>();
    for (std::int64_t b = 0; b < batch.size(); ++b)
        for (std::int64_t t = 0; t < batch.steps(); ++t)
            if (w[t][b] > 0) samples.push_back({history[b], l[t][b], e[t][b], dp[t][b], dq[t][b]});
}

}  // namespace

std::vector<ErrorSample> evaluate(const Law& law, std::span<const Batch> batches) {
    const torch::NoGradGuard no_gradients;
    std::vector<ErrorSample> samples;
    for (const Batch& batch : batches) add_samples(law, batch, samples);
    return samples;
}

}  // namespace sandgraph::training
