#include "results/kept_run.hpp"

#include <fmt/format.h>

#include "base/console.hpp"
#include "base/hash.hpp"
#include "base/revision.hpp"
#include "io/checkpoint.hpp"
#include "io/run_file.hpp"
#include "scene/scene_hash.hpp"

namespace sandgraph::results {
namespace {

namespace fs = std::filesystem;

// Of this scene, by this program, on as many threads: times of others tell nothing of the scene.
bool is_of(const fs::path& folder, const std::string& hash, int threads) {
    if (!fs::exists(folder / "run.h5")) return false;
    const io::RunInfo info = io::read_run(folder / "run.h5").info;
    return info.scene_hash == hash && info.git == revision() && info.threads == threads;
}

}  // namespace

std::optional<FinishedRun> kept_run(simulation::RunRequest request, const DrawPictures& draw) {
    const fs::path folder = request.folder;
    const bool same =
        is_of(folder, hex(scene::scene_hash(simulation::scene_of(request))), simulation::threads_of(request));
    if (same && fs::exists(folder / "summary.json")) return read_finished_run(folder);
    request.resume = same && fs::exists(folder / io::checkpoint_name);
    if (!request.resume) io::remove_restart_files(folder);
    tell(fmt::format("--- {}\n", folder.string()));
    if (run_scene(request, draw) != simulation::RunEnd::finished) return std::nullopt;
    return read_finished_run(folder);
}

}  // namespace sandgraph::results
