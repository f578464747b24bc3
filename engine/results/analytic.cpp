#include "results/analytic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sandgraph::results {
namespace {

constexpr double table_start = 20, table_step = 5;          // [deg]
constexpr std::array<double, 6> table{2.5, 3, 4, 5, 7, 9};  // H_cr/B
constexpr double shallow_at_least = 5;                      // H/B, see critical_embedment

double squared(double a) { return a * a; }

}  // namespace

double critical_embedment_table(double friction_angle) {
    const double degrees = friction_angle * 180 / std::numbers::pi;
    const double at = std::clamp((degrees - table_start) / table_step, 0.0, double(table.size() - 1));
    const auto k = std::min(static_cast<std::size_t>(at), table.size() - 2);
    return std::lerp(table[k], table[k + 1], at - static_cast<double>(k));
}

double critical_embedment(double friction_angle) {
    return std::max(critical_embedment_table(friction_angle), shallow_at_least);
}

double meyerhof_adams(double embedment_ratio, double friction_angle) {
    return meyerhof_adams(embedment_ratio, friction_angle, critical_embedment(friction_angle));
}

// docs/how_it_works.md (eq. 43).
double meyerhof_adams(double embedment_ratio, double friction_angle, double critical_ratio) {
    const double side = nominal_uplift_coefficient * std::tan(friction_angle);
    if (embedment_ratio <= critical_ratio) return embedment_ratio * side + 1;
    return (2 - critical_ratio / embedment_ratio) * critical_ratio * side + 1;
}

// (eq. 43a)
double meyerhof_adams_thick(double embedment_ratio, double thickness_ratio, double friction_angle) {
    if (embedment_ratio > critical_embedment(friction_angle)) return std::nan("");
    const double reach = squared(embedment_ratio + thickness_ratio) / embedment_ratio;
    return reach * nominal_uplift_coefficient * std::tan(friction_angle) + 1;
}

double white_cheuk_bolton(double embedment_ratio, double friction_angle, double dilation_angle, double k0) {
    const double dilated = std::tan(dilation_angle), rubbed = std::tan(friction_angle) - dilated;
    const double normal = (1 + k0) / 2 - (1 - k0) * std::cos(2 * dilation_angle) / 2;
    return 1 + embedment_ratio * (dilated + rubbed * normal);
}

// (eq. 44)
double biarez(double embedment_ratio, double friction_angle) {
    if (embedment_ratio <= 1) return 0;
    return 4 * std::numbers::pi * (1 - 1 / embedment_ratio) * std::tan(friction_angle);
}

double rankine_active(double friction_angle) {
    return squared(std::tan(std::numbers::pi / 4 - friction_angle / 2));
}

double rankine_passive(double friction_angle) {
    return squared(std::tan(std::numbers::pi / 4 + friction_angle / 2));
}

}  // namespace sandgraph::results
