#pragma once
#include "training/law.hpp"

namespace sandgraph::training {

// Recurrent baseline: a gated recurrent unit (Cho et al. 2014) that reads the increments one after the other.
// Its answer depends on how finely a path is cut.
class GruLaw : public Law {
  public:
    GruLaw(std::int64_t members, std::uint64_t seed);
    Prediction rollout(const Batch& batch) const override;
    std::int64_t members() const override { return U.size(0); }

    torch::Tensor W, U, b, V;  // [E, in, 3H], [E, H, 3H], [E, 1, 3H], [E, H, 3]; gates: reset, keep, new
};

}  // namespace sandgraph::training
