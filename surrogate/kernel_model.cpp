#include "surrogate/kernel_model.hpp"

#include "base/contracts.hpp"

namespace sandgraph::surrogate {
namespace {

PackedLayer packed(const Layer& layer) {
    PackedLayer p{layer.inputs, layer.outputs, {}, layer.bias};
    for (std::size_t first = 0; first < layer.outputs;) {
        const std::size_t rows = first + PackedLayer::block <= layer.outputs ? PackedLayer::block : 1;
        for (std::size_t i = 0; i < layer.inputs; ++i)
            for (std::size_t r = 0; r < rows; ++r)
                p.weight.push_back(layer.weight[(first + r) * layer.inputs + i]);
        first += rows;
    }
    return p;
}

}  // namespace

KernelModel::KernelModel(Model m) : model(std::move(m)), layout{model.elements, model.members.size()} {
    for (const Member& member : model.members) {
        auto& stack = layers.emplace_back();
        for (const Layer& layer : member.layers) stack.push_back(packed(layer));
    }
    for (std::size_t i = 0; i < feature_count; ++i)
        inverse_width[i] = 1 / (model.ranges[i].high - model.ranges[i].low);
    SG_ENSURE(layers.size() == model.members.size());
}

}  // namespace sandgraph::surrogate
