#include "graph/rve_pool.hpp"

#include "base/contracts.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace sandgraph::graph {
namespace {

constexpr double kLargestPiece = 0.1;  // strain of one update that catches up

// Every job names a packing of the pool, none twice.
[[maybe_unused]] bool each_once(std::span<const RveJob> jobs, std::size_t packings) {
    std::vector<std::uint8_t> named(packings, 0);
    return std::ranges::all_of(
        jobs, [&](const RveJob& job) { return job.rve < packings && named[job.rve]++ == 0; });
}

class LocalPool final : public RvePool {
  public:
    LocalPool(const std::vector<std::shared_ptr<const dem::CompactPacking>>& initial,
              const dem::Material& material, const dem::RveOptions& options)
        : material_(material), options_(options), unbounded_(options) {
        unbounded_.steps_max = 0;
        rves_.reserve(initial.size());
        for (const auto& packing : initial) rves_.emplace_back(packing);
        floating_.assign(rves_.size(), 0);
    }

    void drive(std::span<const RveJob> jobs, std::span<RveAnswer> answers) override {
        SG_EXPECT(jobs.size() == answers.size());
        SG_EXPECT(each_once(jobs, rves_.size()));
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, jobs.size(), 1),
            [&](const auto& range) {
                for (std::size_t slot = range.begin(); slot < range.end(); ++slot)
                    answers[slot] = run(jobs[slot], workspaces_.local());
            },
            tbb::simple_partitioner());
    }

    Mat2 stress(std::size_t rve) const override { return rves_[rve].stress(); }
    double strain_per_step(std::size_t rve) const override {
        return rves_[rve].strain_per_step(material_, options_);
    }
    double porosity(std::size_t rve) const override { return rves_[rve].porosity(); }
    std::size_t owning() const override {
        return static_cast<std::size_t>(
            std::ranges::count_if(rves_, [](const dem::Rve& r) { return r.owns_packing(); }));
    }
    const dem::Rve& rve(std::size_t rve) const override { return rves_[rve]; }

    void copy(std::size_t from, std::size_t to) override {
        std::vector<std::uint8_t> bytes;
        ByteWriter out(bytes);
        rves_[from].save(out);
        ByteReader in(bytes);
        load_one(to, in);
    }
    void save(ByteWriter& out) const override {
        for (const dem::Rve& r : rves_) r.save(out);
    }
    void load(ByteReader& in) override {
        for (std::size_t k = 0; k < rves_.size(); ++k) load_one(k, in);
    }

  private:
    RveAnswer run(const RveJob& job, dem::Workspace& work) {
        RveAnswer out;
        out.caught_up = !job.path || catch_up(job, out.report, work);
        const dem::RveOptions& options = job.may_wait ? options_ : unbounded_;
        if (out.caught_up && job.increment) advance(job.rve, *job.increment, options, out.report, work);
        const dem::Rve& rve = rves_[job.rve];
        floating_[job.rve] = rve.floating();
        out.stress = rve.stress(), out.volume_ratio = rve.volume_ratio();
        if (out.report.unfinished) out.to_follow = rve.strain_to_follow();
        if (job.observed) out.seen = dem::observe(rve, material_);
        return out;
    }

    // Whether the path's end was reached.
    bool catch_up(const RveJob& job, dem::RveReport& report, dem::Workspace& work) {
        while (!job.path->done() && report.dem_steps < job.path_steps) {
            const double budget = (job.path_steps - report.dem_steps) * strain_per_step(job.rve);
            advance(job.rve, job.path->advance(std::min(budget, kLargestPiece)), unbounded_, report, work);
        }
        return job.path->done();
    }

    void advance(std::size_t rve, const Mat2& F_inc, const dem::RveOptions& options, dem::RveReport& sum,
                 dem::Workspace& work) {
        const dem::RveReport r = rves_[rve].update(F_inc, material_, options, work);
        sum.dem_steps += r.dem_steps;
        sum.unfinished = r.unfinished;
        sum.inertial_number = std::max(sum.inertial_number, r.inertial_number);
        if (!failed(sum.status)) sum.status = r.status;
    }

    void load_one(std::size_t rve, ByteReader& in) {
        rves_[rve].load(in);
        floating_[rve] = rves_[rve].floating();
    }

    dem::Material material_;
    dem::RveOptions options_, unbounded_;
    std::vector<dem::Rve> rves_;
    tbb::enumerable_thread_specific<dem::Workspace> workspaces_;  // scratch, no state
};

}  // namespace

std::unique_ptr<RvePool> local_pool(const std::vector<std::shared_ptr<const dem::CompactPacking>>& initial,
                                    const dem::Material& material, const dem::RveOptions& options) {
    return std::make_unique<LocalPool>(initial, material, options);
}

}  // namespace sandgraph::graph
