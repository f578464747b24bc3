#include "training/law.hpp"

#include <torch/types.h>

#include "training/element_law.hpp"
#include "training/gru_law.hpp"
#include "training/mlp_law.hpp"

namespace sandgraph::training {

const char* name_of(Rung rung) {
    constexpr std::array names = {"elastic", "fitted", "learned", "mlp", "gru"};
    return names[static_cast<std::size_t>(rung)];
}

std::shared_ptr<Law> make_law(Rung rung, std::int64_t members, std::uint64_t seed, torch::Dtype type) {
    std::shared_ptr<Law> law;
    if (rung == Rung::mlp)
        law = std::make_shared<MlpLaw>(members, seed);
    else if (rung == Rung::gru)
        law = std::make_shared<GruLaw>(members, seed);
    else
        law = std::make_shared<ElementLaw>(rung, members, seed);
    law->to(type);
    return law;
}

torch::Tensor layer_weights(std::int64_t members, std::int64_t in, std::int64_t out, double gain) {
    return gain / std::sqrt(static_cast<double>(in)) * torch::randn({members, in, out}, torch::kDouble);
}

}  // namespace sandgraph::training
