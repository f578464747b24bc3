#include "mpm/band_stress.hpp"

#include <cmath>

#include "base/contracts.hpp"
#include "mpm/parallel_bands.hpp"

namespace sandgraph::mpm {
namespace {

Deviator strain_of(const Mat2& F_inc) {
    return {0.5 * (F_inc(0, 0) - F_inc(1, 1)), 0.5 * (F_inc(0, 1) + F_inc(1, 0))};
}

// A normal distribution is 2 sqrt(2 ln 2) deviations wide at half height.
double variance_of(double length) { return length * length / (8 * std::log(2.0)); }

// R X R^T with the rotation of F_inc = R U.
Deviator turned(const Deviator& X, const Mat2& F_inc) {
    const double a = F_inc(0, 0) + F_inc(1, 1), b = F_inc(1, 0) - F_inc(0, 1), n = 1 / (a * a + b * b);
    const double c = (a * a - b * b) * n, s = 2 * a * b * n;
    return {c * X[0] - s * X[1], s * X[0] + c * X[1]};
}

}  // namespace

BandStress::BandStress(double length, double p_wave_modulus, const Points& points, double cell)
    : length_(length), modulus_(stiffness * p_wave_modulus) {
    SG_EXPECT(length >= 0 && p_wave_modulus > 0);
    if (!active()) return;
    over_ = LengthMean(variance_of(length), points.half, cell);
    own_.assign(points.size(), Deviator::Zero());
    strain_ = mean_ = own_, total_.resize(points.size());
}

void BandStress::advance(const Points& points, std::size_t p) {  // docs/how_it_works.md (eq. 7b)
    const double limit = strength * mean_stress(points.stress[p]);
    Deviator& X = own_[p];
    if (!(limit > 0)) return X.setZero(), void();
    const Deviator grown = turned(X, points.F_inc[p]) + modulus_ * (strain_[p] - mean_[p]);
    X = grown / (1 + modulus_ * std::hypot(mean_[p][0], mean_[p][1]) / limit);
}

std::span<const Stress> BandStress::stress(const Points& points, const Order& order, const Grid& grid) {
    SG_EXPECT(own_.size() == points.size());
    over_.weigh(points, order, grid);
    for_points(order, [&](std::size_t p) { strain_[p] = strain_of(points.F_inc[p]); });
    over_.mean(strain_, order, mean_);
    for_points(order, [&](std::size_t p) { advance(points, p); });
    over_.mean(own_, order, mean_);
    for_points(order, [&](std::size_t p) {
        const Deviator added = own_[p] - mean_[p];
        const Stress& s = points.stress[p];
        total_[p] = {s.xx + added[0], s.yy - added[0], s.xy + added[1]};
    });
    return total_;
}

double BandStress::work(const Points& points) const {
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        sum += points.volume[p] * ((own_[p] - mean_[p]) * strain_of(points.F_inc[p])).sum();
    return 2 * sum;
}

void BandStress::archive(Archive& a) {
    if (!active()) return;
    std::vector<double> values;
    for (const Deviator& X : own_) values.insert(values.end(), {X[0], X[1]});
    field_of_known_length(a, "bands/stress", values);
    for (std::size_t p = 0; p < own_.size(); ++p) own_[p] = {values[2 * p], values[2 * p + 1]};
}

}  // namespace sandgraph::mpm
