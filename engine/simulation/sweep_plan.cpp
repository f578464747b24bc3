#include "simulation/sweep_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/process.hpp"
#include "io/checkpoint.hpp"
#include "io/summary.hpp"
#include "packings/samples.hpp"
#include "scene/scene_hash.hpp"

namespace sandgraph::simulation {
namespace {

namespace fs = std::filesystem;

void require_grains(const scene::SweepTable& table, const scene::Scene& scene) {
    if (table.spec.samples > 1 && scene.ground.law != scene::Law::rve)
        throw InputError(table.spec.where("samples"), fmt::format("samples = {}", table.spec.samples),
                         "samples are base packings, and a closed-form law has none: all would be the same",
                         "leave it out, or write ground.law = \"rve\" under [set]");
}

// What is wrong with a scene is told with the row that makes it so.
scene::Scene scene_of_row(const scene::SweepTable& table, const scene::SweepRow& row,
                          const RunRequest& request) try {
    scene::Scene scene = scene_of(request);
    require_grains(table, scene);
    require_feasible(scene, estimate(scene, 1));
    return scene;
} catch (const InputError& error) {
    if (std::string_view(error.what()).starts_with(table.spec.file + ":")) throw;
    const InputError::Where where =
        row.where.file.empty() ? InputError::Where{table.spec.file, 0} : row.where;
    throw InputError(where, fmt::format("row {} is no scene to run", row.name), error.what(),
                     "change the row; nothing was started");
}

void add_row(SweepPlan& plan, std::size_t k) {
    const scene::SweepRow& row = plan.table.rows[k];
    std::uint64_t seed = 0;
    for (int sample = 1; sample <= plan.table.spec.samples; ++sample) {
        SweepRun run;
        run.row = k, run.sample = sample;
        run.request.scene = plan.table.spec.scene;
        run.request.folder = (plan.folder / "rows" / row.name / std::to_string(sample)).string();
        run.request.set = plan.table.overrides(row);
        run.request.resume = true;
        // The first sample is the row as it stands, so that it stays when samples are added; the seed of
        // another stands last and wins.
        if (sample > 1)
            run.request.set.push_back(fmt::format("grains.seed={}", packings::sample_seed(seed, sample - 1)));
        run.scene = scene_of_row(plan.table, row, run.request);
        if (sample == 1) seed = run.scene.ground.grains.seed;
        run.scene_hash = hex(scene::scene_hash(run.scene));
        run.estimate = estimate(run.scene, 1);
        plan.runs.push_back(std::move(run));
    }
}

const char* mode_word(scene::SweepMode mode) { return mode == scene::SweepMode::full ? "full" : "screening"; }

double gigabytes(const std::vector<const SweepRun*>& runs, int jobs) {
    std::vector<double> bytes;
    for (const SweepRun* run : runs) bytes.push_back(run->estimate.bytes);
    std::ranges::sort(bytes, std::greater{});
    double sum = 0;
    for (std::size_t k = 0; k < bytes.size() && k < static_cast<std::size_t>(jobs); ++k) sum += bytes[k];
    return sum / 1e9;
}

}  // namespace

std::string SweepPlan::name(const SweepRun& run) const {
    return fmt::format("{}/{}", table.rows[run.row].name, run.sample);
}

SweepPlan plan_sweep(const std::string& file, const fs::path& folder) {
    SweepPlan plan{scene::read_sweep_table(file), folder, {}};
    scene::SweepSpec& spec = plan.table.spec;
    if (spec.mode != scene::SweepMode::scene)
        spec.set.push_back({"mode", {fmt::format("'{}'", mode_word(spec.mode)), mode_word(spec.mode)}, {}});
    for (std::size_t k = 0; k < plan.table.rows.size(); ++k) add_row(plan, k);
    return plan;
}

RunState state_of(const SweepRun& run) {
    const fs::path folder = run.folder(), summary = folder / "summary.json";
    const bool checkpoint = fs::exists(folder / io::checkpoint_name) ||
                            fs::exists(io::previous_checkpoint(folder / io::checkpoint_name));
    if (fs::exists(summary) && !checkpoint) {
        if (io::read_summary(summary).scene_hash == run.scene_hash) return RunState::finished;
        throw InputError({folder.string(), 0}, "holds a finished run of another scene",
                         "the table has changed since", "remove the folder, or give another with -o");
    }
    if (fs::exists(run.failure())) return RunState::failed;
    return checkpoint ? RunState::stopped : RunState::waiting;
}

std::vector<const SweepRun*> unfinished(const SweepPlan& plan) {
    std::vector<const SweepRun*> out;
    for (const SweepRun& run : plan.runs)
        if (state_of(run) != RunState::finished) out.push_back(&run);
    return out;
}

int room_for(const std::vector<const SweepRun*>& runs) {
    int jobs = 1;
    while (jobs < static_cast<int>(runs.size()) && gigabytes(runs, jobs + 1) * 1e9 <= memory_limit()) ++jobs;
    return jobs;
}

void require_room(const std::vector<const SweepRun*>& runs, int jobs) {
    const double needed = gigabytes(runs, jobs), there = memory_limit() / 1e9;
    if (needed > there)
        throw InputError(
            {"--jobs"}, fmt::format("{}", jobs),
            fmt::format("so many runs may need {:.3g} GB, there is room for {:.3g}", needed, there),
            fmt::format("take {} at most", room_for(runs)));
}

}  // namespace sandgraph::simulation
