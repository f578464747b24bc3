#include "laboratory/probe.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/console.hpp"
#include "base/revision.hpp"
#include "io/history_file.hpp"
#include "laboratory/run_probe.hpp"
#include "packings/compressed_packings.hpp"
#include "packings/history_row.hpp"

namespace sandgraph::laboratory {
namespace {

constexpr std::size_t kBatch = 64;  // histories (with their twins) held in memory at once

// Runs job(0) ... job(count - 1) in parallel and tells how far it is.
template <class Job>
void each(std::size_t count, Tally& tally, std::string_view stage, Job&& job) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const auto& range) {
            for (std::size_t k = range.begin(); k < range.end(); ++k) {
                job(k);
                tally.done(stage);
            }
        },
        tbb::simple_partitioner());
}

// The packings of one base packing follow each other in the plan.
std::vector<ProbeSample> prepare(const ProbePlan& plan, const scene::ProbeSpec& spec,
                                 const ProgressCallback& progress) {
    std::vector<ProbeSample> samples(plan.packings.size());
    const auto pressures = static_cast<std::size_t>(spec.packings.pressures);
    Tally tally(samples.size() / pressures, progress);
    each(samples.size() / pressures, tally, "packings", [&](std::size_t base) {
        tbb::this_task_arena::isolate([&] {
            const packings::CompressedPackings packings(plan.packings[base * pressures].grains);
            const double friction = packings.friction();
            for (std::size_t k = base * pressures; k < (base + 1) * pressures; ++k) {
                samples[k].row = packings.row(plan.packings[k].pressure);
                samples[k].traits = packings.traits(samples[k].row, friction);
            }
        });
    });
    return samples;
}

std::vector<io::HistoryPacking> described(const ProbePlan& plan, const std::vector<ProbeSample>& samples) {
    std::vector<io::HistoryPacking> out;
    for (std::size_t k = 0; k < samples.size(); ++k)
        out.push_back(packings::history_packing(samples[k].row, samples[k].traits, plan.packings[k].grains));
    return out;
}

}  // namespace

void write_probe(const scene::ProbeSpec& spec, const std::filesystem::path& out,
                 const ProgressCallback& progress) {
    const ProbePlan plan = plan_probe(spec);
    const std::vector<ProbeSample> samples = prepare(plan, spec, progress);
    io::HistoryWriter writer(out, {"probe", spec.text, version(), revision()}, described(plan, samples),
                             plan.histories);
    const std::size_t jobs = plan.jobs.size();
    Tally tally(jobs, progress);
    for (std::size_t begin = 0; begin < jobs; begin += kBatch) {
        const std::size_t end = std::min(begin + kBatch, jobs);
        std::vector<std::vector<io::HistoryRow>> rows(end - begin);
        each(end - begin, tally, "strain paths",
             [&](std::size_t k) { rows[k] = run_probe(plan.jobs[begin + k], plan, samples, spec); });
        for (const auto& of_job : rows) writer.append(of_job);
    }
    writer.commit();
}

}  // namespace sandgraph::laboratory
