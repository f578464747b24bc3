#include "graph/screening/gate.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace sandgraph::graph {
namespace {

constexpr double kBeyond = std::numeric_limits<double>::infinity();

// Passed when `value` rises above the threshold.
double rising(double value, double threshold) {
    if (value <= 0) return 0;
    return threshold > 0 ? value / threshold : kBeyond;
}

// Passed when a measure that is 1 in an elastic state falls below the threshold.
double falling(double value, double threshold) { return (1 - value) / (1 - threshold); }

double tension_level(double p, double threshold) {
    if (threshold <= 0) return 0;
    return p > 0 ? threshold / p : kBeyond;
}

}  // namespace

// docs/how_it_works.md (eq. 38).
double deviatoric_strain(const Mat2& F) {
    // l1^2 + l2^2 = |F|^2 and l1 l2 = det F give cosh(ln l1 - ln l2) = |F|^2/(2 det F); written so that small
    // strains keep their digits: |F|^2 - 2 det F = (Fxx - Fyy)^2 + (Fxy + Fyx)^2.
    const double a = F(0, 0) - F(1, 1), b = F(0, 1) + F(1, 0);
    const double excess = (a * a + b * b) / (2 * F.determinant());
    return std::log1p(excess + std::sqrt(excess * (excess + 2)));
}

Verdict judge(const GateView& view, const GateSettings& settings) {
    Verdict worst;
    if (!settings.active) return worst;
    const auto consider = [&](double level, Reason reason) {
        if (level > worst.level) worst = {level, reason};
    };
    const double p = mean_stress(view.stress), ratio = p > 0 ? deviator(view.stress) / p : kBeyond;
    consider(rising(deviatoric_strain(view.F), settings.strain), Reason::strain);
    if (view.peak_friction > 0)
        consider(rising(ratio / view.peak_friction, settings.stress_ratio), Reason::stress_ratio);
    consider(tension_level(p, settings.tension), Reason::tension);
    consider(rising(view.distance, settings.distance), Reason::distance);
    consider(rising(view.spread, settings.spread), Reason::spread);
    consider(falling(view.work, settings.second_order_work), Reason::second_order_work);
    consider(falling(view.acoustic, settings.acoustic), Reason::acoustic_tensor);
    return worst;
}

}  // namespace sandgraph::graph
