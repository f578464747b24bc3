#pragma once
#include "training/law.hpp"

namespace sandgraph::training {

// The literature's baseline: a plain network from a summary of the strain history (total strain, its fading
// memory at three lengths, the path's length) to the stress.
class MlpLaw : public Law {
  public:
    MlpLaw(std::int64_t members, std::uint64_t seed);
    Prediction rollout(const Batch& batch) const override;
    std::int64_t members() const override { return W1.size(0); }

    torch::Tensor W1, b1, W2, b2, W3;  // [E, in, out], [E, 1, out]

  private:
    torch::Tensor answer(const torch::Tensor& x) const;
};

}  // namespace sandgraph::training
