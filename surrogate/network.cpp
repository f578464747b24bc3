#include "surrogate/network.hpp"

#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::surrogate {
namespace {

std::vector<double> affine(const Layer& layer, std::span<const double> x) {
    SG_EXPECT(x.size() == layer.inputs && layer.bias.size() == layer.outputs);
    SG_EXPECT(layer.weight.size() == layer.inputs * layer.outputs);
    std::vector<double> y = layer.bias;
    for (std::size_t o = 0; o < layer.outputs; ++o)
        for (std::size_t i = 0; i < layer.inputs; ++i) y[o] += layer.weight[o * layer.inputs + i] * x[i];
    return y;
}

}  // namespace

std::vector<double> forward(std::span<const Layer> layers, std::span<const double> x) {
    std::vector<double> y(x.begin(), x.end());
    for (std::size_t l = 0; l < layers.size(); ++l) {
        y = affine(layers[l], y);
        if (l + 1 == layers.size()) break;
        for (double& v : y) v = std::tanh(v);
    }
    return y;
}

}  // namespace sandgraph::surrogate
