#include "base/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/contracts.hpp"

namespace sandgraph {
namespace {

// Two-sided 95 % quantile of Student's t, by degrees of freedom.
double student(std::size_t freedom) {
    constexpr std::array quantiles{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262};
    return freedom <= quantiles.size() ? quantiles[freedom - 1] : 1.96 + 2.5 / static_cast<double>(freedom);
}

}  // namespace

Sample sample_of(std::span<const double> values) {
    Sample out{.count = values.size()};
    if (values.empty()) return out;
    const auto n = static_cast<double>(values.size());
    out.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    if (values.size() < 2) return out;
    double squares = 0;
    for (const double value : values) squares += (value - out.mean) * (value - out.mean);
    out.deviation = std::sqrt(squares / (n - 1));
    out.ci95 = student(values.size() - 1) * std::sqrt(squares / (n - 1) / n);
    return out;
}

double quantile(std::vector<double> values, double share) {
    SG_EXPECT(share >= 0 && share <= 1);
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    const double place = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

}  // namespace sandgraph
