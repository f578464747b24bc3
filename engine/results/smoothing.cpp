#include "results/smoothing.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sandgraph::results {
namespace {

constexpr std::size_t fewest = 5;  // points in a window

struct Window {
    std::size_t begin, end;
    double half_width;
};

Window window_at(std::span<const double> x, std::size_t k, double half_width) {
    Window w{k, k + 1, half_width};
    const auto inside = [&](std::size_t j) { return std::abs(x[j] - x[k]) < half_width; };
    while (w.begin > 0 && (inside(w.begin - 1) || k - w.begin < fewest / 2)) --w.begin;
    while (w.end < x.size() && (inside(w.end) || w.end - w.begin < fewest)) ++w.end;
    while (w.begin > 0 && w.end - w.begin < fewest) --w.begin;
    // The farthest point keeps a weight above zero.
    w.half_width = std::max({half_width, 1.1 * (x[k] - x[w.begin]), 1.1 * (x[w.end - 1] - x[k])});
    return w;
}

// Coefficients of a + b t + c t^2, t = (x - x_k)/half_width.
Eigen::Vector3d local_fit(std::span<const double> x, std::span<const double> y, std::size_t k,
                          const Window& w) {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (std::size_t j = w.begin; j < w.end; ++j) {
        const double t = (x[j] - x[k]) / w.half_width, u = 1 - std::abs(t * t * t);
        const double weight = std::max(0.0, u * u * u);
        const Eigen::Vector3d phi(1, t, t * t);
        A += weight * phi * phi.transpose();
        b += weight * y[j] * phi;
    }
    return A.ldlt().solve(b);
}

}  // namespace

Smoothed smooth(std::span<const double> x, std::span<const double> y, double half_width) {
    Smoothed result;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const Window w = window_at(x, k, half_width);
        const Eigen::Vector3d fit = local_fit(x, y, k, w);
        result.value.push_back(fit[0]);
        result.slope.push_back(fit[1] / w.half_width);
    }
    return result;
}

double rms_difference(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return a.empty() ? 0 : std::sqrt(sum / static_cast<double>(a.size()));
}

double linear_slope(std::span<const double> x, std::span<const double> y) {
    const auto n = static_cast<double>(x.size());
    const double x_mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
    double xx = 0, xy = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        xx += (x[k] - x_mean) * (x[k] - x_mean);
        xy += (x[k] - x_mean) * y[k];
    }
    return xx > 0 ? xy / xx : 0;
}

}  // namespace sandgraph::results
