#include "surrogate/coefficients.hpp"

#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::surrogate {
namespace {

double tanh_dilatancy(const Member& m, std::size_t k, const CriticalPull& critical, double output) {
    const double own = m.dilatancy[k] + output;
    return m.share[k] * std::tanh(own + critical.share * (critical.toward - own));
}

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

// docs/how_it_works.md (eqs. 36 and 37).
Coefficients coefficients(const Model& model, const Member& m, const PointConstants& point, double p,
                          double strength_scale, const CriticalPull& critical,
                          std::span<const double> outputs) {
    const std::size_t M = model.elements;
    SG_EXPECT(outputs.empty() || outputs.size() == 3 * M + 1);
    SG_EXPECT(m.share.size() == M && m.strength.size() == M && m.dilatancy.size() == M);
    SG_EXPECT(!(p <= 0) && point.pressure > 0);
    const auto output = [&](std::size_t i) { return outputs.empty() ? 0.0 : outputs[i]; };
    const auto factor = [&](std::size_t i, double b) { return bounded_factor(output(i), b); };
    const double stiffening = std::pow(p / point.pressure, m.exponent);
    Coefficients c;
    c.bulk = point.bulk * stiffening * m.bulk * factor(3 * M, model.bounds.bulk);
    for (std::size_t k = 0; k < M; ++k) {
        c.shear.push_back(point.shear * stiffening * m.share[k] * factor(k, model.bounds.shear));
        const double limit = model.frictional ? m.strength[k] * factor(M + k, model.bounds.strength)
                                              : never_slips * m.share[k];
        c.strength.push_back(strength_scale * limit);
        // At most twice the friction: slip never makes energy, 2 t : dgamma >= p D dgamma.
        c.dilatancy.push_back(
            std::min(tanh_dilatancy(m, k, critical, output(2 * M + k)), 2 * c.strength.back()));
    }
    return c;
}

}  // namespace sandgraph::surrogate
