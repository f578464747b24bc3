#include "results/run_scene.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "base/console.hpp"
#include "base/error.hpp"
#include "base/process.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/xdmf.hpp"
#include "results/run_summary.hpp"
#include "simulation/build_screening.hpp"
#include "simulation/check_run.hpp"
#include "simulation/run_session.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::results {
namespace {

namespace fs = std::filesystem;

simulation::RunOptions options_of(const simulation::RunRequest& a, const scene::Scene& scene) {
    simulation::RunOptions o;
    o.folder = !a.folder.empty()              ? fs::path(a.folder)
               : !scene.output.folder.empty() ? fs::path(scene.output.folder)
                                              : fs::path("out") / fs::path(a.scene).stem();
    o.threads = simulation::threads_of(a);
    o.until = a.until > 0 ? std::min(a.until, scene.anchor.pull_to) : scene.anchor.pull_to;
    o.resume = a.resume;
    o.resume ? simulation::require_checkpoint(o.folder, scene) : simulation::require_no_checkpoint(o.folder);
    return o;
}

packings::PreparedGround prepare(const scene::Scene& scene) {
    StageProgress progress;
    // A surrogate that cannot be used is refused before the packings are made.
    std::shared_ptr<const stress::Surrogate> surrogate;
    if (scene.mode == scene::Mode::screening) surrogate = surrogate::load_surrogate(scene.screening.model);
    packings::PreparedGround ground = packings::prepare_ground(scene, progress.callback());
    ground.surrogate = std::move(surrogate);
    return ground;
}

// A failure on the way (a full disk) tells what there is to go on from.
simulation::RunEnd run(simulation::RunSession& session, const simulation::RunOptions& o) {
    try {
        return session.run();
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        if (!fs::exists(o.folder / io::checkpoint_name)) throw;
        throw std::runtime_error(fmt::format("{}; the last checkpoint is kept for --resume", error.what()));
    }
}

// What is left to do when the plate has gone all the way.
void finish(const simulation::RunSession& session, const simulation::RunOptions& o, const scene::Scene& scene,
            const packings::PreparedGround& ground, const DrawPictures& draw) {
    const io::Summary summary = summarise(session, scene, ground, o.threads);
    io::write_summary(o.folder / "summary.json", summary);
    io::write_xdmf(o.folder / "fields.xdmf", session.frame_file());
    tell(summary_text(summary, scene, ground));
    if (scene.output.pictures) tell(draw(read_finished_run(o.folder)) + "\n");
    tell(fmt::format("results in {}\n", o.folder.string()));
}

simulation::RunEnd run_all(const simulation::RunRequest& a, const DrawPictures& draw) {
    const scene::Scene scene = simulation::scene_of(a);
    const simulation::RunOptions options = options_of(a, scene);
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(options.threads));
    simulation::require_memory(scene);
    io::require_writable(options.folder);
    const packings::PreparedGround ground = prepare(scene);
    simulation::RunSession session(scene, ground, options);
    if (run(session, options) == simulation::RunEnd::interrupted) {
        notice(fmt::format("stopped at d/B {:.4f}; go on with: {}", session.pull().d_over_B(),
                           simulation::resume_command(a, options.folder)));
        return simulation::RunEnd::interrupted;
    }
    finish(session, options, scene, ground, draw);
    if (session.went_all_the_way()) session.discard_restart_files();
    return simulation::RunEnd::finished;
}

}  // namespace

simulation::RunEnd run_scene(const simulation::RunRequest& a, const DrawPictures& draw) try {
    return run_all(a, draw);
} catch (const Interrupted&) {
    notice("stopped while packings were made; those that are ready are kept: the same command goes on");
    return simulation::RunEnd::interrupted;
}

}  // namespace sandgraph::results
