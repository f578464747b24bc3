#include "training/make_law.hpp"

#include "training/element_law.hpp"
#include "training/gru_law.hpp"
#include "training/mlp_law.hpp"

namespace sandgraph::training {

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

}  // namespace sandgraph::training
