#pragma once
#include <memory>

#include "training/law.hpp"

namespace sandgraph::training {

// An untrained law; initial parameters are drawn from `seed`.
std::shared_ptr<Law> make_law(Rung rung, std::int64_t members, std::uint64_t seed, torch::Dtype type);

}  // namespace sandgraph::training
