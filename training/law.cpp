#include "training/law.hpp"

#include <torch/types.h>

#include <cmath>

namespace sandgraph::training {

const char* name_of(Rung rung) {
    constexpr std::array names = {"elastic", "fitted", "learned", "mlp", "gru"};
    return names[static_cast<std::size_t>(rung)];
}

void Law::start_from(const surrogate::Model&, const std::string&) {}
std::optional<surrogate::Model> Law::served(double) const { return {}; }

torch::Tensor layer_weights(std::int64_t members, std::int64_t in, std::int64_t out, double gain) {
    return gain / std::sqrt(static_cast<double>(in)) * torch::randn({members, in, out}, torch::kDouble);
}

}  // namespace sandgraph::training
