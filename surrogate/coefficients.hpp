#pragma once
#include <span>
#include <vector>

#include "surrogate/features.hpp"
#include "surrogate/model.hpp"

namespace sandgraph::surrogate {

// Output of the layers for the input x: tanh after each but the last.
std::vector<double> forward(std::span<const Layer> layers, std::span<const double> x);

// Friction limit of the elastic rung, over the element's share.
inline constexpr double never_slips = 1e9;

// What the elements obey during one substep.
struct Coefficients {
    double bulk = 0;                // K [Pa]
    std::vector<double> shear;      // G_k [Pa]
    std::vector<double> strength;   // r_k: |t_k| <= r_k p
    std::vector<double> dilatancy;  // D_k: plastic volume -D_k dgamma_k, compression positive
};

// Equations: docs/how_it_works.md. F(o) = (1 + b e^o)/(b + e^o) (eq. 36), between 1/b and b, 1 at o = 0.
inline double bounded_factor(double o, double b) {
    const double u = std::exp(o);
    return (1 + b * u) / (b + u);
}

// What critical state makes of a dilatancy before its tanh (eq. 37): share * toward + (1 - share) * its own.
struct CriticalPull {
    double share = 0, toward = 0;
};
inline CriticalPull critical_pull(const CriticalState& c, double void_ratio, double p, double gamma) {
    const double g2 = gamma * gamma, away = void_ratio - c.void_ratio + c.slope * (p / 1e5);
    return {g2 / (g2 + c.mature * c.mature), -c.pull * (away / 0.04)};
}

// `outputs` [3 M + 1] of the member's network, or empty for the fitted constants alone. p [Pa] is the mean
// stress there, `strength_scale` the point's own factor on the friction limits (1 but for a start above
// them).
Coefficients coefficients(const Model& model, const Member& member, const PointConstants& point, double p,
                          double strength_scale, const CriticalPull& critical,
                          std::span<const double> outputs);

}  // namespace sandgraph::surrogate
