// Does the audit tell the truth? From runs in which every point was audited (audit.share = 1) the true mean
// error of the surrogate's stress is known at every frame; samples of 1 % drawn anew, as an audit draws them,
// give intervals: how many contain it?
// Usage: bench_audit_coverage RUN_FOLDER...
#include <fmt/format.h>

#include <cmath>

#include "graph/screening/audit.hpp"
#include "io/run_record.hpp"
#include "results/field_values.hpp"
#include "results/finished_run.hpp"

namespace {

using namespace sandgraph;

constexpr int draws = 2000;

struct Coverage {
    double truth = 0, width = 0;         // mean error; mean half width of the intervals
    int inside = 0, below = 0, all = 0;  // truth within, truth below the interval
};

Coverage coverage_of(const std::vector<double>& errors, std::size_t population, double share) {
    Coverage c;
    for (const double e : errors)
        c.truth += std::isfinite(e) ? std::min(e, graph::audit_cap) / static_cast<double>(population) : 0;
    for (int draw = 1; draw <= draws; ++draw) {
        std::vector<double> sample;
        for (const std::int32_t p : graph::draw_sample(errors.size(), {share, std::uint64_t(draw), 1}))
            if (std::isfinite(errors[static_cast<std::size_t>(p)]))
                sample.push_back(errors[static_cast<std::size_t>(p)]);
        const graph::AuditRow row = graph::estimate(sample, population);
        if (!std::isfinite(row.ci95)) continue;
        ++c.all;
        c.width += row.ci95;
        c.inside += std::abs(row.mean - c.truth) <= row.ci95;
        c.below += c.truth < row.mean - row.ci95;
    }
    c.width /= std::max(1, c.all);
    return c;
}

}  // namespace

int main(int argc, char** argv) {
    fmt::print("{:28}{:>8}{:>10}{:>10}{:>12}{:>10}\n", "run", "d/B", "truth", "+-", "contains it", "below");
    for (int i = 1; i < argc; ++i) {
        const results::FinishedRun run = results::read_finished_run(argv[i]);
        for (std::size_t k = 0; k < run.record.frames; ++k) {
            const io::Frame frame = io::read_run_frame(run.frame_file(), k);
            std::vector<double> errors;
            for (const float e : results::field(frame, "audited error", 1).values) errors.push_back(e);
            std::size_t population = 0;
            for (const double e : errors) population += std::isfinite(e);
            if (population == 0 || frame.d_over_B <= 0) continue;
            const Coverage c = coverage_of(errors, population, 0.01);
            fmt::print("{:28}{:8.3f}{:10.4f}{:10.4f}{:11.1f}%{:9.1f}%\n", run.folder.filename().string(),
                       frame.d_over_B, c.truth, c.width, 100.0 * c.inside / c.all, 100.0 * c.below / c.all);
        }
    }
}
