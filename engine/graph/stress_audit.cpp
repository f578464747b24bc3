#include "graph/stress_audit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/random.hpp"

namespace sandgraph::graph {

std::vector<std::int32_t> draw_sample(std::size_t points, const AuditSettings& settings) {
    const auto wanted = static_cast<std::size_t>(std::ceil(settings.share * static_cast<double>(points)));
    std::vector<std::int32_t> ids(points);
    std::iota(ids.begin(), ids.end(), 0);
    Random random(settings.seed, 0xA0D17);
    for (std::size_t k = 0; k < std::min(wanted, points); ++k) {
        const auto left = static_cast<double>(points - k);
        std::swap(ids[k], ids[k + static_cast<std::size_t>(random.uniform() * left)]);
    }
    ids.resize(std::min(wanted, points));
    std::sort(ids.begin(), ids.end());
    return ids;
}

AuditRow estimate(std::span<const double> sample, std::size_t population) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto n = static_cast<double>(sample.size()), N = static_cast<double>(population);
    AuditRow row{0, n, N, unknown, unknown};
    if (sample.empty()) return row;
    row.mean = std::accumulate(sample.begin(), sample.end(), 0.0) / n;
    if (sample.size() < 2) return row;
    double square = 0;
    for (const double e : sample) square += (e - row.mean) * (e - row.mean);
    row.ci95 = student_975(n - 1) * std::sqrt(square / (n - 1) / n * std::max(0.0, 1 - n / N));
    return row;
}

double student_975(double freedom) {
    if (freedom < 3) return freedom < 2 ? 12.7062 : 4.3027;
    constexpr double z = 1.959963985, z2 = z * z;
    const double v = freedom;
    return z * (1 + (z2 + 1) / (4 * v) + ((5 * z2 + 16) * z2 + 3) / (96 * v * v) +
                (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * v * v * v));
}

}  // namespace sandgraph::graph
