#include "simulation/run_session.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/process.hpp"
#include "base/revision.hpp"
#include "io/checkpoint.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/progress.hpp"
#include "simulation/scene_spec.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kReached = 1e-9;  // slack on marks

ProgressState standing(const Simulation& simulation, double target, double load) {
    return {simulation.steps(),   simulation.mark(), target, load, simulation.state().law->grain_use().active,
            simulation.anchored()};
}

}  // namespace

RunSession::RunSession(const scene::Scene& scene, const packings::PreparedGround& ground,
                       const RunOptions& options)
    : options_(options),
      end_(end_mark(scene)),
      simulation_(simulation_of(scene, ground, options.crew ? options.crew->pool() : graph::local_pool)),
      recorders_(scene, ground, *simulation_, options),
      checkpoint_(options.folder, hex(scene::scene_hash(scene)), scene.output.checkpoint_every) {
    if (options.resume) checkpoint_.read([this](Archive& a) { archive(a); });
}

RunEnd RunSession::run() try { return go(); } catch (const InputError&) {
    throw;
} catch (const std::exception& error) {
    if (!std::filesystem::exists(options_.folder / io::checkpoint_name)) throw;
    throw std::runtime_error(fmt::format("{}; the last checkpoint is kept for --resume", error.what()));
}

RunEnd RunSession::go() {
    clock_.start();
    catch_interrupts();
    Progress progress;
    bool stopping = interrupted();
    while (!reached(options_.until) && !stopping) {
        const bool due = checkpoint_.due();
        stopping = interrupted();
        announce_step(due || stopping);
        simulation_->step();
        recorders_.after_step(*simulation_);
        if (due) checkpoint();
        if (progress.due())
            progress.update(standing(*simulation_, options_.until, recorders_.loads().last()));
    }
    if (went_all_the_way()) {
        simulation_->state().law->conclude(simulation_->d_over_B());
        recorders_.settle(*simulation_);
        recorders_.commit();
    } else {
        checkpoint();
    }
    recorders_.write_history();
    return reached(options_.until) ? RunEnd::finished : RunEnd::interrupted;
}

// A crew has to know before the step whether it must wait behind it.
void RunSession::announce_step(bool checkpoint) const {
    if (!options_.crew) return;
    const double next = simulation_->next_mark();
    options_.crew->announce(checkpoint || next >= options_.until - 2 * kReached ||
                            recorders_.look_by(next + kReached));
}

bool RunSession::reached(double mark) const { return simulation_->mark() >= mark - kReached; }

void RunSession::checkpoint() {
    recorders_.settle(*simulation_);
    checkpoint_.write(simulation_->d_over_B(), [this](Archive& a) { archive(a); });
}

void RunSession::archive(Archive& a) {
    simulation_->archive(a);
    clock_.archive(a);
    recorders_.archive(a, *simulation_);
}

void RunSession::discard_restart_files() { io::remove_restart_files(options_.folder); }

}  // namespace sandgraph::simulation
