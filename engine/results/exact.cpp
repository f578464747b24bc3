#include "results/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace sandgraph::results {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180 / std::numbers::pi;

// phi [deg], N_gamma smooth, N_gamma rough.
using Row = std::array<double, 3>;
constexpr auto kFooting = std::to_array<Row>({{5, 0.0845, 0.1134},
                                              {10, 0.2809, 0.4332},
                                              {15, 0.6991, 1.1814},
                                              {20, 1.5786, 2.8389},
                                              {25, 3.4611, 6.4913},
                                              {30, 7.6530, 14.7543},
                                              {35, 17.5771, 34.4761},
                                              {40, 43.1866, 85.5655},
                                              {45, 117.5757, 234.2127}});

// Lagrange's cubic through four rows from `first` on, of the logarithm.
double between(std::size_t first, double degrees, std::size_t column) {
    double sum = 0;
    for (std::size_t i = first; i < first + 4; ++i) {
        double weight = 1;
        for (std::size_t j = first; j < first + 4; ++j)
            if (j != i) weight *= (degrees - kFooting[j][0]) / (kFooting[i][0] - kFooting[j][0]);
        sum += weight * std::log(kFooting[i][column]);
    }
    return std::exp(sum);
}

// Of the ground above the body's upper face [m].
double cover(const scene::Scene& s, const scene::Body& body) { return s.domain.depth - body.high(1); }

ExactLoad of_anchor(const scene::Scene& s, double gamma, double phi) {
    const double ratio = s.anchor.embedment_ratio, B = s.anchor.width;
    return {uplift_factor(ratio, phi), gamma * ratio * B * B};
}

// The upper edge at the surface: a wall that is pushed on one side and left on the other.
ExactLoad of_vertical_anchor(const scene::Scene& s, double gamma, double phi) {
    const double ratio = s.anchor.embedment_ratio, B = s.anchor.width;
    const bool wall = std::fabs(ratio - 1) < 1e-9 && s.anchor.friction_angle == 0;
    return {wall ? 0.5 * (passive_factor(phi) - active_factor(phi)) : kUnknown, gamma * ratio * B * B};
}

ExactLoad of_wall(const scene::Scene& s, const scene::Body& wall, double gamma, double factor) {
    const double H = s.domain.depth - wall.low(1);
    return {wall.friction_angle == 0 ? factor : kUnknown, 0.5 * gamma * H * H};
}

ExactLoad of_footing(const scene::Body& body, double gamma, double phi) {
    const double B = body.width(), delta = body.friction_angle;
    const bool known = delta == 0 || delta >= phi;
    return {known ? footing_factor(phi, delta > 0) : kUnknown, 0.5 * gamma * B * B};
}

ExactLoad of_trapdoor(const scene::Scene& s, const scene::Body& body, double gamma, double phi) {
    const double H = cover(s, body), B = body.width();
    return {body.velocity[1] > 0 ? uplift_factor(H / B, phi) : kUnknown, gamma * H * B};
}

ExactLoad of_body(const scene::Scene& s, const scene::Body& body, double gamma, double phi) {
    switch (s.exact) {
        case scene::ExactCase::footing:
            return of_footing(body, gamma, phi);
        case scene::ExactCase::footing_surcharge:
            return {gamma == 0 ? surcharge_factor(phi) : kUnknown, s.ground.surcharge * body.width()};
        case scene::ExactCase::wall_passive:
            return of_wall(s, body, gamma, passive_factor(phi));
        case scene::ExactCase::wall_active:
            return of_wall(s, body, gamma, active_factor(phi));
        default:
            return of_trapdoor(s, body, gamma, phi);
    }
}

// Dry, cohesionless sand whose flow is associated.
bool is_known_ground(const scene::Scene& s) {
    const stress::MohrCoulombConstants& c = s.ground.continuum;
    return s.ground.law == scene::Law::mohr_coulomb && c.cohesion == 0 &&
           std::fabs(c.dilation_angle - c.friction_angle) < 1e-9;
}

}  // namespace

double footing_factor(double friction_angle, bool rough) {
    const double degrees = friction_angle * kDegrees;
    if (!(degrees >= kFooting.front()[0] - 1e-9 && degrees <= kFooting.back()[0] + 1e-9)) return kUnknown;
    const auto below = static_cast<std::size_t>((degrees - kFooting.front()[0]) / 5);
    const std::size_t first = std::min(below > 0 ? below - 1 : 0, kFooting.size() - 4);
    return between(first, degrees, rough ? 2 : 1);
}

double passive_factor(double phi) { return (1 + std::sin(phi)) / (1 - std::sin(phi)); }
double active_factor(double phi) { return 1 / passive_factor(phi); }

double surcharge_factor(double phi) {
    return std::exp(std::numbers::pi * std::tan(phi)) * passive_factor(phi);
}

double uplift_factor(double embedment_ratio, double phi) { return 1 + embedment_ratio * std::tan(phi); }

std::optional<ExactLoad> exact_load(const scene::Scene& s, double density) {
    if (s.exact == scene::ExactCase::none || !s.loaded()) return std::nullopt;
    const double gamma = density * s.ground.gravity, phi = s.ground.continuum.friction_angle;
    const scene::Body* body = s.loaded_body();
    ExactLoad out = body                                           ? of_body(s, *body, gamma, phi)
                    : s.exact == scene::ExactCase::anchor_vertical ? of_vertical_anchor(s, gamma, phi)
                                                                   : of_anchor(s, gamma, phi);
    const bool loaded_otherwise = s.ground.surcharge > 0 && s.exact != scene::ExactCase::footing_surcharge;
    if (!is_known_ground(s) || loaded_otherwise) out.factor = kUnknown;
    return out;
}

double limit_load(std::span<const double> d_over_B, std::span<const double> load) {
    if (load.empty()) return kUnknown;
    const double from = 0.8 * d_over_B.back();
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < load.size(); ++k)
        if (d_over_B[k] >= from) sum += load[k], count += 1;
    return sum / count;
}

}  // namespace sandgraph::results
