#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "graph/settings.hpp"

namespace sandgraph::graph {

// An error counts as 1 at most: a stress off by all of p or more is wholly wrong.
inline constexpr double audit_cap = 1;

// What an audit says of the points that the surrogate answers for: the mean over them of
// |sigma_surrogate - sigma_DEM|/max(p_DEM, 1 kPa), audit_cap at most, where the packing has been driven along
// the point's own strain path. It does not see what the error has done to that path.
struct AuditRow {
    double d_over_B = 0;
    double points = 0;      // in the sample
    double population = 0;  // points that the surrogate answers for
    double mean = 0;        // NaN without a sample
    double ci95 = 0;        // half width of the 95 % confidence interval of the mean; NaN below two points
};

// `share` of `points` ids (rounded up), drawn without replacement, each set as likely; in rising order.
std::vector<std::int32_t> draw_sample(std::size_t points, const AuditSettings& settings);

// Mean of a simple random sample from `population` values, with an interval that holds whatever their
// distribution between 0 and audit_cap: a few points that are far off are easily missed by a sample, and
// Student's interval then contains the truth three times in four only (bench_audit_coverage). Bound of Gaffke
// (2005) from 2,000 draws, the larger of both sides, with the correction for a finite population: a whole
// census has none.
AuditRow estimate(std::span<const double> sample, std::size_t population);

}  // namespace sandgraph::graph
