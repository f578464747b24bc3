#include "graph/screening/audit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/contracts.hpp"
#include "base/random.hpp"
#include "graph/stress_arithmetic.hpp"
#include "graph/visits.hpp"

namespace sandgraph::graph {
namespace {

constexpr double kFloor = 1000;  // mean stress that errors are shares of, at least [Pa]

// Equations: docs/how_it_works.md. Half width (eq. 41a): means of the values and one more, unseen, under
// weights drawn evenly from all that add up to 1: at the top of the range (unseen = audit_cap) their 97.5 %
// quantile bounds the true mean from above, at its bottom the 2.5 % quantile from below.
double half_width(const std::vector<double>& values, double mean) {
    constexpr std::size_t draws = 2000, tail = draws / 40;
    Random random(0x9AFF4E);
    std::vector<double> upper(draws), lower(draws);
    for (std::size_t d = 0; d < draws; ++d) {
        const double unseen = -std::log(1 - random.uniform());
        double sum = 0, weights = unseen;
        for (const double v : values) {
            const double w = -std::log(1 - random.uniform());
            sum += w * v, weights += w;
        }
        upper[d] = (sum + unseen * audit_cap) / weights, lower[d] = sum / weights;
    }
    std::ranges::nth_element(upper, upper.end() - tail);
    std::ranges::nth_element(lower, lower.begin() + tail);
    return std::max(upper[draws - tail] - mean, mean - lower[tail]);
}

}  // namespace

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
    SG_EXPECT(sample.size() <= population);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto n = static_cast<double>(sample.size()), N = static_cast<double>(population);
    AuditRow row{0, n, N, unknown, unknown};
    if (sample.empty()) return row;
    std::vector<double> errors(sample.begin(), sample.end());
    for (double& e : errors) e = std::min(e, audit_cap);
    row.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
    row.ci95 = n < N ? half_width(errors, row.mean) * std::sqrt(1 - n / N) : 0;
    return row;
}

AuditSample::AuditSample(std::size_t points, const AuditSettings& settings)
    : points_(draw_sample(points, settings)),
      place_of_(points, -1),
      errors_(points_.size(), 0),
      every_(settings.every) {
    for (std::size_t k = 0; k < points_.size(); ++k)
        place_of_[static_cast<std::size_t>(points_[k])] = static_cast<std::int32_t>(k);
}

// (eq. 41)
void AuditSample::measure(std::int32_t place, const Stress& answered, const Stress& truth) {
    errors_[static_cast<std::size_t>(place)] =
        norm(difference(answered, truth)) / reference_pressure(truth, kFloor);
}

void AuditSample::schedule_after(double d_over_B) {
    SG_EXPECT(every_ > 0);
    while (next_ <= d_over_B) next_ += every_;
}

// The sample itself comes from the settings; the scene's hash tells that it is the same.
void AuditSample::save(ByteWriter& out) const { out.put(errors_), out.put(next_); }

void AuditSample::load(ByteReader& in) {
    in.take_same(errors_), in.take(next_);
    require_state(next_ >= 0, "audits");
}

}  // namespace sandgraph::graph
