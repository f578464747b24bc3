#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "surrogate/model.hpp"

namespace sandgraph::surrogate {

// Deviator of a symmetric plane tensor: (t_xx - t_yy)/2 + i t_xy. A rotation by theta multiplies it by
// exp(2 i theta).
using Deviator = std::complex<double>;
using Features = std::array<double, feature_count>;

// What a point knows of its packing before any strain.
struct PointConstants {
    double pressure = 0, void_ratio = 0;  // p0 [Pa], e0 = n/(1 - n)
    double bulk = 0, shear = 0;           // K0, G0 [Pa]
    double coordination = 0, peak_friction = 0;
};

inline constexpr std::array<const char*, feature_count> feature_names{
    "ln(p / 10 kPa) / 3",         "(e - 0.22) / 0.04",     "(q/p) / 0.4",
    "ln(1 + gamma / 0.001) / 3",  "ln(p0 / 10 kPa) / 3",   "(e0 - 0.22) / 0.04",
    "(coordination - 3.5) / 0.5", "(sin phi - 0.5) / 0.1", "fabric : s / (0.1 p)"};

// Invariants under rotation and reflection. `volume` is J since the start, s the stress deviator [Pa], gamma
// the accumulated plastic shear. q/p is smoothed by 0.01: its slope stays finite at s = 0.
inline Features features(const PointConstants& c, double p, double volume, Deviator s, Deviator fabric,
                         double gamma) {
    const double void_ratio = (1 + c.void_ratio) * volume - 1;
    const double q_over_p = std::sqrt(std::norm(s) / (p * p) + 1e-4);
    return {std::log(p / 1e4) / 3,
            (void_ratio - 0.22) / 0.04,
            q_over_p / 0.4,
            std::log(1 + gamma / 1e-3) / 3,
            std::log(c.pressure / 1e4) / 3,
            (c.void_ratio - 0.22) / 0.04,
            (c.coordination - 3.5) / 0.5,
            (c.peak_friction - 0.5) / 0.1,
            (fabric.real() * s.real() + fabric.imag() * s.imag()) / (0.1 * p)};
}

// Clamps the features to what was trained; answers the largest distance outside, in widths of the range.
inline double clamp_to_trained(const std::array<FeatureRange, feature_count>& ranges, Features& x) {
    double distance = 0;
    for (std::size_t i = 0; i < feature_count; ++i) {
        const double inside = std::clamp(x[i], ranges[i].low, ranges[i].high);
        distance = std::max(distance, std::abs(x[i] - inside) / (ranges[i].high - ranges[i].low));
        x[i] = inside;
    }
    return distance;
}

}  // namespace sandgraph::surrogate
