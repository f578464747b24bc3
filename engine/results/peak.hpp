#pragma once
#include <optional>
#include <span>

namespace sandgraph::results {

// How the load-displacement curve breaks out (Vesic 1973): the slope first reaches zero (a peak, or the start
// of a level stretch), or a steady minimum above zero, or neither within the curve.
enum class BreakoutKind { zero_slope, steady_slope, still_rising };

struct Breakout {
    BreakoutKind kind = BreakoutKind::still_rising;
    double d_over_B = 0;
    double load = 0;  // smoothed, in the unit of the curve; the largest one reached if still rising
};

struct VesicCriterion {
    double half_width = 0.005;      // of the smoothing window, in d/B
    double confirm_over = 0.02;     // after a zero slope the load must not rise again over this d/B ...
    double confirm_rise = 0.01;     // ... by more than this share
    double steady_share = 0.25;     // last share of the curve in which the slope must be steady
    double steady_least = 0.09;     // d/B that this share must span: shorter stretches are straight anywhere
    double steady_change = 0.05;    // change of that slope from its first to its second half, as a share
    double slope_tolerance = 0.02;  // of the initial slope: what counts as having reached the steady one
};

// d_over_B increasing; the curve should start before its rise. Fewer than 10 points: still rising.
Breakout breakout(std::span<const double> d_over_B, std::span<const double> load, const VesicCriterion& = {});

// The largest smoothed load after `breakout`, if it is higher by more than criterion.confirm_rise.
std::optional<Breakout> higher_later(std::span<const double> d_over_B, std::span<const double> load,
                                     const Breakout& breakout, const VesicCriterion& = {});

// Mean load over the last tenth of the curve's displacement.
double late_load(std::span<const double> d_over_B, std::span<const double> load);

}  // namespace sandgraph::results
