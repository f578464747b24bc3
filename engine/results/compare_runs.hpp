#pragma once
#include <limits>
#include <string>

#include "results/finished_run.hpp"

namespace sandgraph::results {

// How one run differs from a reference of the same ground. Shares are of the reference.
struct Comparison {
    double common = 0;  // d/B up to which both go; to different ends costs and unfinished peaks are NaN
    // |peak - reference peak| / reference peak, of the smoothed curves; |d/B - reference d/B| at it.
    double peak_error = std::numeric_limits<double>::quiet_NaN(), peak_position_error = peak_error;
    double curve_error = 0;           // rms of the load difference over the common d/B, share of the peak
    double curve_error_smoothed = 0;  // the same of the curves smoothed over 0.005 in d/B
    int frames = 0;                   // field frames at a d/B that both have, the start apart
    double displacement_error = 0;    // rms over points and frames of |u - u_ref|, share of the pull d
    double stress_error = 0;          // rms over points and frames of |sigma - sigma_ref| / max(p_ref, 1 kPa)
    double wall_ratio = 0, cpu_ratio = 0;      // reference's over the other's: how many times faster
    double dem_share_mean = 0, dem_share = 0;  // of the other: over the run, at its end
    double audit_mean = 0, audit_ci95 = 0;     // of the other; NaN without an audit
    // Of the other's hand-overs, 95th percentiles, shares of p; NaN without any: the jump, its part that the
    // ground feels in one step, and the same points' largest step after it.
    double jump_p95 = 0, felt_p95 = 0, ordinary_p95 = 0;
    double replay_share = 0;  // of the other's DEM steps: to catch up along recorded paths
};

// Errors that cannot be told (no common frame, no peak) are NaN. InputError when the grounds differ in
// their number of points.
Comparison compare_runs(const FinishedRun& reference, const FinishedRun& other);

std::string to_text(const Comparison& c);
std::string to_json(const Comparison& c);

}  // namespace sandgraph::results
