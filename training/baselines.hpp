#pragma once
#include <memory>

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

// Recurrent baseline: a gated recurrent unit (Cho et al. 2014) that reads the increments one after the other.
// Its answer depends on how finely a path is cut.
class GruLaw : public Law {
  public:
    GruLaw(std::int64_t members, std::uint64_t seed);
    Prediction rollout(const Batch& batch) const override;
    std::int64_t members() const override { return U.size(0); }

    torch::Tensor W, U, b, V;  // [E, in, 3H], [E, H, 3H], [E, 1, 3H], [E, H, 3]; gates: reset, keep, new
};

// Constants of the packing as the baselines see them, of the order of one [B, 7]: ln p0, ln K0/p0, ln G0/p0,
// e0, Z0 and both parts of the initial deviator over p0.
torch::Tensor packing_input(const Batch& batch);
inline constexpr std::int64_t packing_inputs = 7;

// Stress from what a baseline's last layer says beyond what it says at rest [T, E, B, 3]: so it starts at the
// initial stress.
Prediction baseline_stress(const torch::Tensor& change, const Batch& batch);

// An untrained law; initial parameters are drawn from `seed`.
std::shared_ptr<Law> make_law(Rung rung, std::int64_t members, std::uint64_t seed, torch::Dtype type);

}  // namespace sandgraph::training
