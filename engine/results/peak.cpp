#include "results/peak.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "results/smoothing.hpp"

namespace sandgraph::results {
namespace {

constexpr std::size_t fewest = 10;       // points that make a curve
constexpr double smallest_share = 0.25;  // of the largest load: nothing below is a breakout
constexpr double late_share = 0.1;

using Curve = std::span<const double>;

std::size_t first_after(Curve d, double at) {
    return static_cast<std::size_t>(std::lower_bound(d.begin(), d.end(), at) - d.begin());
}

// After point k the load stays where it is or falls. Half the confirming length must be there to tell.
bool confirmed(Curve d, const Smoothed& s, std::size_t k, const VesicCriterion& c) {
    if (d.back() - d[k] < 0.5 * c.confirm_over) return false;
    const auto begin = s.value.begin() + static_cast<long>(k);
    const auto end = s.value.begin() + static_cast<long>(first_after(d, d[k] + c.confirm_over));
    return *std::max_element(begin, std::max(end, begin + 1)) <= (1 + c.confirm_rise) * s.value[k];
}

std::optional<Breakout> zero_slope(Curve d, const Smoothed& s, const VesicCriterion& c) {
    const double largest = *std::max_element(s.value.begin(), s.value.end());
    for (std::size_t k = 1; k < d.size(); ++k)
        if (s.slope[k] <= 0 && s.value[k] >= smallest_share * largest && confirmed(d, s, k, c)) {
            const std::size_t top = s.value[k - 1] > s.value[k] ? k - 1 : k;
            return Breakout{BreakoutKind::zero_slope, d[top], s.value[top]};
        }
    return std::nullopt;
}

// Standard deviation of a least-squares slope over n equally spaced points that span `length`.
double slope_noise(double noise, std::size_t n, double length) {
    return noise * std::sqrt(12.0 / static_cast<double>(std::max<std::size_t>(n, 1))) / length;
}

struct Tail {
    double slope = 0;
    bool steady = false;
};

Tail tail_of(Curve d, Curve load, const Smoothed& s, double steepest, const VesicCriterion& c) {
    const double length = c.steady_share * (d.back() - d.front());
    const std::size_t begin = first_after(d, d.back() - length), n = (d.size() - begin) / 2;
    if (n < 2 || length < c.steady_least) return {};
    const double first = linear_slope(d.subspan(begin, n), load.subspan(begin, n));
    const double second = linear_slope(d.subspan(begin + n), load.subspan(begin + n));
    const double slope = linear_slope(d.subspan(begin), load.subspan(begin));
    const double noise = rms_difference(load.subspan(begin), Curve(s.value).subspan(begin));
    const double allowed = c.steady_change * std::max(slope, c.slope_tolerance * steepest) +
                           3 * slope_noise(noise, n, 0.5 * length);
    return {slope, std::abs(second - first) <= allowed && slope < 0.5 * steepest};
}

std::optional<Breakout> steady_slope(Curve d, Curve load, const Smoothed& s, const VesicCriterion& c) {
    const double steepest = *std::max_element(s.slope.begin(), s.slope.end());
    const Tail tail = tail_of(d, load, s, steepest, c);
    if (!tail.steady) return std::nullopt;
    const auto start =
        static_cast<std::size_t>(std::max_element(s.slope.begin(), s.slope.end()) - s.slope.begin());
    for (std::size_t k = start; k < d.size(); ++k)
        if (s.slope[k] <= tail.slope + c.slope_tolerance * (steepest - tail.slope))
            return Breakout{BreakoutKind::steady_slope, d[k], s.value[k]};
    return std::nullopt;
}

Breakout largest(Curve d, const Smoothed& s) {
    const auto at =
        static_cast<std::size_t>(std::max_element(s.value.begin(), s.value.end()) - s.value.begin());
    return {BreakoutKind::still_rising, d[at], s.value[at]};
}

}  // namespace

Breakout breakout(Curve d, Curve load, const VesicCriterion& criterion) {
    if (d.size() < fewest)
        return d.empty() ? Breakout{} : Breakout{BreakoutKind::still_rising, d.back(), load.back()};
    const Smoothed s = smooth(d, load, criterion.half_width);
    if (const auto found = zero_slope(d, s, criterion)) return *found;
    if (const auto found = steady_slope(d, load, s, criterion)) return *found;
    return largest(d, s);
}

std::optional<Breakout> higher_later(Curve d, Curve load, const Breakout& breakout, const VesicCriterion& c) {
    if (d.size() < fewest || breakout.kind == BreakoutKind::still_rising) return std::nullopt;
    const Smoothed s = smooth(d, load, c.half_width);
    const auto begin = s.value.begin() + static_cast<long>(first_after(d, breakout.d_over_B));
    const auto at = std::max_element(begin, s.value.end());
    if (at == s.value.end() || *at <= (1 + c.confirm_rise) * breakout.load) return std::nullopt;
    return Breakout{BreakoutKind::still_rising, d[static_cast<std::size_t>(at - s.value.begin())], *at};
}

double late_load(Curve d, Curve load) {
    if (d.empty()) return 0;
    const std::size_t begin =
        std::min(first_after(d, d.back() - late_share * (d.back() - d.front())), d.size() - 1);
    const double sum = std::accumulate(load.begin() + static_cast<long>(begin), load.end(), 0.0);
    return sum / static_cast<double>(load.size() - begin);
}

}  // namespace sandgraph::results
