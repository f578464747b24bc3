#include "simulation/prepare_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "base/console.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/folder_lock.hpp"
#include "io/run_file.hpp"
#include "scene/check_scene.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/scene_spec.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::simulation {
namespace {

namespace fs = std::filesystem;

// Without one the run has ended, perhaps killed before it had cleared up, or never began.
void require_checkpoint(const fs::path& folder, const scene::Scene& scene) {
    const fs::path checkpoint = folder / io::checkpoint_name;
    if (fs::exists(checkpoint) || fs::exists(io::previous_checkpoint(checkpoint))) {
        io::CheckpointReader(checkpoint, hex(scene::scene_hash(scene)));  // throws
        return;
    }
    const bool ended = fs::exists(folder / "summary.json");
    if (ended) io::remove_restart_files(folder);
    throw InputError(
        {folder.string(), 0}, "nothing to resume",
        ended ? "the run has ended: its summary.json is there" : "there is no checkpoint in this folder",
        "run without --resume, or give the run's folder with -o");
}

void require_no_checkpoint(const fs::path& folder) {
    if (!fs::exists(folder / io::checkpoint_name) || fs::exists(folder / "summary.json")) return;
    throw InputError({folder.string(), 0}, "holds a run that was stopped on its way",
                     "its checkpoint.h5 would be lost",
                     "go on with it by --resume, or remove the folder, or give another with -o");
}

void require_memory(const scene::Scene& scene) {
    constexpr double bytes_a_point = 1000;  // without the packing of one that strains
    const double spacing = scene::point_spacing(scene.domain),
                 points = scene.domain.width * scene.domain.depth / (spacing * spacing),
                 memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                          static_cast<double>(sysconf(_SC_PAGESIZE));
    if (points * bytes_a_point > memory)
        throw InputError({scene.file, 0}, fmt::format("{:.2g} material points", points),
                         fmt::format("they need {:.2g} GB, this machine has {:.2g}",
                                     points * bytes_a_point / 1e9, memory / 1e9),
                         "look at domain.width, domain.depth and domain.cell");
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
    o.threads = threads_of(request);
    const double end = end_mark(scene);
    if (request.until > end) notice(fmt::format("--until {:g}: the run ends at {:g}", request.until, end));
    o.until = request.until > 0 ? std::min(request.until, end) : end;
    o.resume = request.resume;
    if (o.resume) {
        require_checkpoint(o.folder, scene);
    } else {
        require_no_checkpoint(o.folder);
        io::require_own_outputs(o.folder);
    }
    return o;
}

packings::PreparedGround prepare(const scene::Scene& scene) {
    require_memory(scene);
    StageProgress progress;
    std::shared_ptr<const stress::Surrogate> surrogate;
    if (scene.mode == scene::Mode::screening) surrogate = surrogate::load_surrogate(scene.screening.model);
    packings::PreparedGround ground = packings::prepare_ground(scene, progress.callback());
    ground.surrogate = std::move(surrogate);
    return ground;
}

}  // namespace sandgraph::simulation
