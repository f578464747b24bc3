#pragma once
#include <span>
#include <vector>

namespace sandgraph::results {

// Value and slope of a noisy curve at each of its abscissae: local quadratic regression (Savitzky & Golay
// 1964, on any spacing) with tricube weights over |x - x_k| < half_width, widened where fewer than 5 points
// fall in.
struct Smoothed {
    std::vector<double> value, slope;
};
Smoothed smooth(std::span<const double> x, std::span<const double> y, double half_width);

// Root mean square of a - b.
double rms_difference(std::span<const double> a, std::span<const double> b);

// Least-squares slope of y over x.
double linear_slope(std::span<const double> x, std::span<const double> y);

}  // namespace sandgraph::results
