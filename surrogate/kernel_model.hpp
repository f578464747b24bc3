#pragma once
#include "surrogate/state_layout.hpp"

namespace sandgraph::surrogate {

// A layer's weights in the order in which the kernel reads them: for each block of 8 outputs (the rest one by
// one) the weights of input 0, of input 1, ...
struct PackedLayer {
    static constexpr std::size_t block = 8;
    std::size_t inputs = 0, outputs = 0;
    std::vector<double> weight, bias;
};

// A model with what the kernel would otherwise work out in every update.
struct KernelModel {
    explicit KernelModel(Model m);

    Model model;
    StateLayout layout;
    std::vector<std::vector<PackedLayer>> layers;  // [member][layer]
    std::array<double, feature_count> inverse_width{};
};

}  // namespace sandgraph::surrogate
