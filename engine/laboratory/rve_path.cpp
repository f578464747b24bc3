#include "laboratory/rve_path.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include "base/error.hpp"
#include "dem/packing/observe.hpp"

namespace sandgraph::laboratory {
namespace {

class RveOnStand {
  public:
    RveOnStand(const dem::Packing& sample, const Mat2& stress, const RvePath& path)
        : path_(path), rve_(dem::compact(sample, path.material, stress)), H_0_(sample.H) {}

    void step(const Mat2& L) {
        const Mat2 F_inc = Mat2::Identity() + path_.test.time_step * L;
        collected_ = F_inc * collected_;
        F_ = F_inc * F_;
        strain_ += path_.test.time_step * 0.5 * (L + L.transpose()).norm();
        ++steps_;
        if (strain_ >= path_.collect) follow();
    }
    // Lets the packing follow what was collected.
    void follow() {
        if (collected_ == Mat2::Identity()) return;
        const dem::RveReport report = rve_.update(collected_, path_.material, path_.options, work_);
        if (report.status == dem::RveStatus::bad_increment || report.status == dem::RveStatus::diverged)
            throw InputError(
                {"element test", 0}, fmt::format("the packing cannot follow step {} of the path", steps_),
                report.status == dem::RveStatus::diverged ? "its grains lie in each other, or flew apart"
                                                          : "too large an increment",
                "strain it less, or in smaller steps");
        collected_.setIdentity();
        strain_ = 0;
    }
    dem::ElementRow row() {
        follow();
        return {steps_, static_cast<double>(steps_) * path_.test.time_step, F_, F_ * H_0_,
                dem::observe(rve_, path_.material)};
    }
    std::int64_t steps() const { return steps_; }

  private:
    const RvePath& path_;
    dem::Rve rve_;
    dem::Workspace work_;
    Mat2 H_0_, F_ = Mat2::Identity(), collected_ = Mat2::Identity();
    double strain_ = 0;
    std::int64_t steps_ = 0;
};

}  // namespace

std::vector<dem::ElementRow> run_rve_path(const dem::Packing& sample, const Mat2& stress,
                                          const RvePath& path) {
    RveOnStand stand(sample, stress, path);
    std::vector<dem::ElementRow> rows{stand.row()};
    for (const dem::PathSegment& segment : path.test.segments) {
        for (std::int64_t step = 0; step < segment.steps; ++step) {
            stand.step(segment.velocity_gradient);
            if (stand.steps() % path.test.sample_every == 0) rows.push_back(stand.row());
        }
        stand.follow();  // a change of direction is never averaged away
    }
    if (rows.back().step != stand.steps()) rows.push_back(stand.row());
    return rows;
}

}  // namespace sandgraph::laboratory
