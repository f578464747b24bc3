#include "training/baseline_input.hpp"

#include <torch/types.h>

namespace sandgraph::training {

using torch::Tensor;

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

}  // namespace sandgraph::training
