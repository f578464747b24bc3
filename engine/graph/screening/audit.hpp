#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_stream.hpp"
#include "base/tensor.hpp"
#include "graph/settings.hpp"
#include "stress/screening_log.hpp"

namespace sandgraph::graph {

// An error counts as 1 at most: a stress off by all of p or more is wholly wrong.
inline constexpr double audit_cap = 1;

using stress::AuditRow;

// `share` of `points` ids (rounded up), drawn without replacement, each set as likely; in rising order.
std::vector<std::int32_t> draw_sample(std::size_t points, const AuditSettings& settings);

// Mean of a simple random sample from `population` values, with an interval that holds whatever their
// distribution between 0 and audit_cap: a few points that are far off are easily missed by a sample, and
// Student's interval then contains the truth three times in four only (bench_audit_coverage). Bound of Gaffke
// (2005) from 2,000 draws, the larger of both sides, with the correction for a finite population: a whole
// census has none. Of one point it is valid, and wide.
AuditRow estimate(std::span<const double> sample, std::size_t population);

// The points of a run that carry a second packing, which only measures the surrogate's stress error: with any
// sample the ground moves bit for bit the same.
class AuditSample {
  public:
    AuditSample(std::size_t points, const AuditSettings& settings);

    std::size_t size() const { return points_.size(); }
    const std::vector<std::int32_t>& points() const { return points_; }
    // Place of the point in the sample, or -1.
    std::int32_t place(std::size_t point) const { return place_of_[point]; }

    // The ground's stress of an audited point beside that of its second packing [Pa, tension positive].
    void measure(std::int32_t place, const Stress& answered, const Stress& truth);
    void forget(std::int32_t place) { errors_[static_cast<std::size_t>(place)] = 0; }
    double error(std::int32_t place) const { return errors_[static_cast<std::size_t>(place)]; }

    // Over the audited points that `counts` takes, for `population` points.
    template <class Counts>
    AuditRow now(std::size_t population, Counts counts) const {
        std::vector<double> sample;
        for (std::size_t k = 0; k < points_.size(); ++k)
            if (counts(points_[k])) sample.push_back(errors_[k]);
        return estimate(sample, population);
    }
    bool due(double d_over_B) const { return d_over_B >= next_; }
    void schedule_after(double d_over_B);  // the next audit

    void save(ByteWriter& out) const;
    void load(ByteReader& in);

  private:
    std::vector<std::int32_t> points_, place_of_;
    std::vector<double> errors_;  // by place, share of p
    double every_, next_ = 0;     // d/B
};

}  // namespace sandgraph::graph
