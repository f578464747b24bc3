#include "app/simulate.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <thread>

#include "app/build_screening.hpp"
#include "app/check_run.hpp"
#include "app/command_line.hpp"
#include "app/resume_command.hpp"
#include "app/run_pictures.hpp"
#include "app/run_session.hpp"
#include "app/run_summary.hpp"
#include "app/stage_progress.hpp"
#include "app/writable.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "io/checkpoint.hpp"
#include "io/xdmf.hpp"
#include "scene/read_scene.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::app {
namespace {

namespace fs = std::filesystem;

RunOptions options_of(const RunRequest& a, const scene::Scene& scene) {
    RunOptions o;
    o.folder = !a.folder.empty()              ? fs::path(a.folder)
               : !scene.output.folder.empty() ? fs::path(scene.output.folder)
                                              : fs::path("out") / fs::path(a.scene).stem();
    o.threads = threads_of(a);
    o.until = a.until > 0 ? std::min(a.until, scene.anchor.pull_to) : scene.anchor.pull_to;
    o.resume = a.resume;
    o.resume ? require_checkpoint(o.folder, scene) : require_no_checkpoint(o.folder);
    return o;
}

PreparedGround prepare(const scene::Scene& scene) {
    StageProgress progress;
    // A surrogate that cannot be used is refused before the packings are made.
    std::shared_ptr<const stress::Surrogate> surrogate;
    if (scene.mode == scene::Mode::screening)
        surrogate = surrogate::load_surrogate(scene.screening.surrogate.model);
    PreparedGround ground =
        prepare_ground(scene, [&progress](std::string_view stage, double f) { progress.update(stage, f); });
    ground.surrogate = std::move(surrogate);
    return ground;
}

// A failure on the way (a full disk) tells what there is to go on from.
RunEnd run(RunSession& session, const RunOptions& o) {
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
void finish(const RunSession& session, const RunOptions& o, const scene::Scene& scene,
            const PreparedGround& ground) {
    const io::Summary summary = summarise(session, scene, ground, o.threads);
    io::write_summary(o.folder / "summary.json", summary);
    io::write_xdmf(o.folder / "fields.xdmf", session.frame_file());
    fmt::print("{}", summary_text(summary, scene, ground));
    if (scene.output.pictures)
        fmt::print("{}\n", draw_pictures(o.folder / "pictures",
                                         {scene, session.record(), session.frame_file(),
                                          unit_load(scene, ground), ground.friction_angle,
                                          equivalent_embedment(scene, ground) / scene.anchor.width}));
    fmt::print("results in {}\n", o.folder.string());
}

}  // namespace

int threads_of(const RunRequest& a) {
    return a.threads > 0 ? a.threads : static_cast<int>(std::thread::hardware_concurrency());
}

scene::Scene scene_of(const RunRequest& a) {
    std::vector<std::string> overrides = a.set;
    if (!a.mode.empty()) overrides.push_back("mode=" + a.mode);
    scene::Scene scene = scene::read_scene(a.scene, overrides);
    if (scene.mode == scene::Mode::screening) {
        if (scene.ground.law != scene::Law::rve)
            throw InputError(a.mode.empty() ? scene.where("mode") : InputError::Where{"--mode"},
                             "mode = \"screening\" of a closed-form law",
                             "a surrogate stands in for packings of grains", "write ground.law = \"rve\"");
        scene.screening.surrogate.model = model_file(scene).string();
    }
    if (!scene.anchor.present)
        throw InputError(scene.where("anchor.present"), "anchor.present = false", "`run` pulls an anchor",
                         "give the scene an [anchor]");
    return scene;
}

namespace {

int simulate_all(const RunRequest& a) {
    const scene::Scene scene = scene_of(a);
    const RunOptions options = options_of(a, scene);
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(options.threads));
    require_memory(scene);
    require_writable(options.folder);
    const PreparedGround ground = prepare(scene);
    RunSession session(scene, ground, options);
    if (run(session, options) == RunEnd::interrupted) {
        fmt::print(stderr, "stopped at d/B {:.4f}; go on with: {}\n", session.pull().d_over_B(),
                   resume_command(a, options.folder));
        return exit_stopped_early;
    }
    finish(session, options, scene, ground);
    if (session.went_all_the_way()) session.discard_restart_files();
    return exit_done;
}

}  // namespace

int simulate(const RunRequest& a) try { return simulate_all(a); } catch (const Interrupted&) {
    fmt::print(stderr,
               "stopped while packings were made; those that are ready are kept: the same command goes on\n");
    return exit_stopped_early;
}

}  // namespace sandgraph::app
