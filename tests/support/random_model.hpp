#pragma once
#include <cmath>
#include <cstdint>

#include "base/random.hpp"
#include "stress/surrogate.hpp"
#include "surrogate/model.hpp"

namespace sandgraph::support {

struct ModelShape {
    std::size_t members = 4, elements = 8, hidden = 16, layers = 3;  // no layers: constant coefficients
};

inline surrogate::Layer random_layer(std::size_t inputs, std::size_t outputs, double size, Random& random) {
    surrogate::Layer layer{inputs, outputs, {}, {}};
    const double width = size / std::sqrt(static_cast<double>(inputs));
    for (std::size_t i = 0; i < inputs * outputs; ++i) layer.weight.push_back(random.uniform(-width, width));
    for (std::size_t i = 0; i < outputs; ++i) layer.bias.push_back(random.uniform(-0.1, 0.1) * size);
    return layer;
}

// Elements that slip one after another, sum of friction limits 0.55.
inline surrogate::Member random_member(const ModelShape& shape, Random& random) {
    surrogate::Member m;
    double shares = 0, strengths = 0;
    for (std::size_t k = 0; k < shape.elements; ++k) {
        m.share.push_back(std::pow(0.6, k) * random.uniform(0.9, 1.1));
        m.strength.push_back(m.share[k] * std::pow(2.2, k));
        m.dilatancy.push_back(random.uniform(-0.3, 0.5));
        shares += m.share[k];
        strengths += m.strength[k];
    }
    for (double& w : m.share) w /= shares;
    for (double& r : m.strength) r *= 0.55 / strengths;
    m.critical = {random.uniform(0.01, 0.2), random.uniform(0.2, 1), random.uniform(0.2, 0.3),
                  random.uniform(0, 0.02)};
    std::size_t width = surrogate::feature_count;
    for (std::size_t l = 0; l < shape.layers; ++l) {
        const std::size_t next = l + 1 == shape.layers ? 3 * shape.elements + 1 : shape.hidden;
        m.layers.push_back(random_layer(width, next, l + 1 == shape.layers ? 0.7 : 1.5, random));
        width = next;
    }
    return m;
}

// A model that check_model and check_physics accept; not trained on anything.
inline surrogate::Model random_model(std::uint64_t seed, const ModelShape& shape = {}) {
    Random random(seed);
    surrogate::Model model;
    model.elements = shape.elements;
    for (surrogate::FeatureRange& range : model.ranges) range = {-1.5, 1.5};
    model.ranges[2] = {0, 2};
    model.ranges[3] = {0, 2};
    for (std::size_t m = 0; m < shape.members; ++m) model.members.push_back(random_member(shape, random));
    model.data_hash = "none";
    model.description = "random weights, for tests";
    return model;
}

// A dense packing at 20 kPa, and a state at rest with q/p = 0.2.
inline stress::PackingTraits dense_traits() { return {20e3, 0.17, 24e6, 15e6, 3.6, 0.02, -0.01, 0.55}; }
inline Stress rest_stress() { return {-16.5e3, -23.5e3, 1.9e3}; }

}  // namespace sandgraph::support
