#include "results/run_scene.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "base/console.hpp"
#include "base/hash.hpp"
#include "base/process.hpp"
#include "io/atomic_file.hpp"
#include "io/xdmf.hpp"
#include "results/run_summary.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/caveats.hpp"
#include "simulation/prepare_run.hpp"
#include "simulation/run_session.hpp"

namespace sandgraph::results {
namespace {

std::string standing(const simulation::Simulation& s) {
    return s.anchored() ? fmt::format("d/B {:.4f}", s.d_over_B()) : fmt::format("{:.4f} s", s.time());
}

void finish(const simulation::RunSession& session, const simulation::RunOptions& o, const scene::Scene& scene,
            const packings::PreparedGround& ground, const DrawPictures& draw) {
    const io::Summary summary = summarise(session, scene, ground, o.threads);
    io::write_summary(o.folder / "summary.json", summary);
    io::write_xdmf(o.folder / "fields.xdmf", session.recorders().frame_file());
    tell(summary_text(summary, scene));
    if (scene.output.pictures) tell(draw(read_finished_run(o.folder)) + "\n");
    tell(fmt::format("results in {}\n", o.folder.string()));
}

simulation::RunEnd run_all(const simulation::RunRequest& a, const DrawPictures& draw) {
    const scene::Scene scene = simulation::scene_of(a);
    if (a.crew) simulation::require_work_for(*a.crew, scene);
    const simulation::RunOptions options = simulation::options_of(a, scene);
    if (options.finished) {
        tell(fmt::format("the run has ended before; results in {}\n", options.folder.string()));
        return simulation::RunEnd::finished;
    }
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(options.threads));
    const packings::PreparedGround ground = simulation::prepare(scene, options.threads);
    if (a.crew) a.crew->begin(a, options, hex(scene::scene_hash(scene)));
    simulation::RunSession session(scene, ground, options);
    for (const std::string& caveat : simulation::caveats(scene, ground, session.simulation()))
        notice("warning: " + caveat);
    if (session.run() == simulation::RunEnd::interrupted) {
        notice(fmt::format("stopped at {}; go on with: {}", standing(session.simulation()),
                           simulation::resume_command(a, options.folder)));
        return simulation::RunEnd::interrupted;
    }
    if (options.crew) notice(options.crew->account());
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
