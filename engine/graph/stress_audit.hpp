#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace sandgraph::graph {

struct AuditSettings {
    double share = 0.01;  // of the points, drawn at random
    std::uint64_t seed = 1;
    double every = 0.01;  // d/B between two audits
};

// What an audit says of the points that the surrogate answers for: the mean over them of
// |sigma_surrogate - sigma_DEM|/max(p_DEM, 1 kPa), where the packing has been driven along the point's own
// strain path. It does not see what the error has done to that path.
struct AuditRow {
    double d_over_B = 0;
    double points = 0;      // in the sample
    double population = 0;  // points that the surrogate answers for
    double mean = 0;        // NaN without a sample
    double ci95 = 0;        // half width of the 95 % confidence interval of the mean; NaN below two points
};

// `share` of `points` ids (rounded up), drawn without replacement, each set as likely; in rising order.
std::vector<std::int32_t> draw_sample(std::size_t points, const AuditSettings& settings);

// Mean of a simple random sample from `population` values, with Student's t interval and the correction for a
// finite population: a whole census has none.
AuditRow estimate(std::span<const double> sample, std::size_t population);

// 97.5 % quantile of Student's t (Abramowitz & Stegun 26.7.5); freedom >= 1.
double student_975(double freedom);

}  // namespace sandgraph::graph
