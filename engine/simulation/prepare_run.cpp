#include "simulation/prepare_run.hpp"

#include <fmt/format.h>

#include "base/console.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/folder_lock.hpp"
#include "io/run_file.hpp"
#include "io/summary.hpp"
#include "scene/check_scene.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/estimate.hpp"
#include "simulation/progress.hpp"
#include "simulation/scene_spec.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::simulation {
namespace {

namespace fs = std::filesystem;

// What --resume finds in the folder.
enum class Found { nothing, checkpoint, finished };

// A run that was killed when it had ended and before it had cleared up is finished, too.
Found found_in(const fs::path& folder, const scene::Scene& scene) {
    const std::string hash = hex(scene::scene_hash(scene));
    const fs::path checkpoint = folder / io::checkpoint_name;
    if (fs::exists(checkpoint) || fs::exists(io::previous_checkpoint(checkpoint))) {
        io::CheckpointReader(checkpoint, hash);  // throws
        return Found::checkpoint;
    }
    if (!fs::exists(folder / "summary.json")) return Found::nothing;
    if (io::read_summary(folder / "summary.json").scene_hash != hash)
        throw InputError({folder.string(), 0}, "holds a finished run of another scene",
                         "there is nothing to go on with",
                         "run without --resume, or give another folder with -o");
    io::remove_restart_files(folder);
    return Found::finished;
}

void require_no_checkpoint(const fs::path& folder) {
    if (!fs::exists(folder / io::checkpoint_name) || fs::exists(folder / "summary.json")) return;
    throw InputError({folder.string(), 0}, "holds a run that was stopped on its way",
                     "its checkpoint.h5 would be lost",
                     "go on with it by --resume, or remove the folder, or give another with -o");
}

// Told where somebody waits for it.
void tell_estimate(const scene::Scene& scene, int threads) {
    constexpr double worth_telling = 30;  // [s]
    const Estimate e = estimate(scene, threads);
    require_feasible(scene, e);
    if (e.seconds > worth_telling)
        notice(fmt::format("{:.0f} points, {:.0f} steps, up to {:.2g} GB; some {} on {} thread{}", e.points,
                           e.steps, e.bytes / 1e9, duration_text(e.seconds), threads,
                           threads == 1 ? "" : "s"));
    if (e.preparation > worth_telling)
        notice(
            fmt::format("{:.0f} in-situ packings, {} a depth row; to make them takes some {}, once: they "
                        "are kept for other runs",
                        e.packings, scene.ground.grains.samples, duration_text(e.preparation)));
}

fs::path folder_of(const RunRequest& request, const scene::Scene& scene) {
    if (!request.folder.empty()) return request.folder;
    if (!scene.output.folder.empty()) return scene.output.folder;
    return fs::path("out") / fs::path(request.scene).stem();
}

}  // namespace

RunOptions options_of(const RunRequest& request, const scene::Scene& scene) {
    RunOptions o;
    o.folder = folder_of(request, scene);
    o.owner = std::make_shared<io::FolderLock>(o.folder);
    for (const fs::path& held : {o.folder, o.folder / "packings"}) io::remove_temporaries(held);
    o.threads = threads_of(request), o.crew = request.crew;
    const double end = end_mark(scene);
    if (request.until > end) notice(fmt::format("--until {:g}: the run ends at {:g}", request.until, end));
    o.until = request.until > 0 ? std::min(request.until, end) : end;
    const Found found = request.resume ? found_in(o.folder, scene) : Found::nothing;
    o.resume = found == Found::checkpoint, o.finished = found == Found::finished;
    if (found != Found::nothing) return o;
    require_no_checkpoint(o.folder);
    io::require_own_outputs(o.folder);
    return o;
}

packings::PreparedGround prepare(const scene::Scene& scene, int threads) {
    tell_estimate(scene, threads);
    StageProgress progress;
    return prepare_quietly(scene, progress.callback());
}

packings::PreparedGround prepare_quietly(const scene::Scene& scene, const ProgressCallback& progress) {
    std::shared_ptr<const stress::Surrogate> surrogate;
    if (scene.mode == scene::Mode::screening) surrogate = surrogate::load_surrogate(scene.screening.model);
    packings::PreparedGround ground = packings::prepare_ground(scene, progress);
    ground.surrogate = std::move(surrogate);
    return ground;
}

void require_work_for(const Crew& crew, const scene::Scene& scene) {
    if (crew.size() == 1) return;
    if (scene.ground.law != scene::Law::rve)
        throw InputError({scene.file}, fmt::format("{} ranks for a closed-form law", crew.size()),
                         "ranks share out packings, and there are none", "run it without mpi");
    const double points = estimate(scene, 1).points;
    if (crew.size() > points)
        throw InputError(
            {scene.file}, fmt::format("{} ranks for {:.0f} material points", crew.size(), points),
            "a rank without a point has nothing to do", fmt::format("start {:.0f} ranks at most", points));
}

}  // namespace sandgraph::simulation
