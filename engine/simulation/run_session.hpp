#pragma once
#include "simulation/run_checkpoint.hpp"
#include "simulation/run_clock.hpp"
#include "simulation/run_recorders.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::simulation {

enum class RunEnd { finished, interrupted };

// One simulation with its outputs: steps it to where the run ends, has it recorded, keeps checkpoints.
class RunSession {
  public:
    // Makes (or, resuming, opens) the run folder: call it when all input is checked.
    RunSession(const scene::Scene& scene, const packings::PreparedGround& ground, const RunOptions& options);
    // A failure on the way (a full disk) says whether there is a checkpoint to go on from.
    RunEnd run();
    // Once every output of a run that went all the way is written: there is nothing left to resume. Before,
    // a kill would lose what was not written yet.
    void discard_restart_files();
    bool went_all_the_way() const { return reached(end_); }

    const Simulation& simulation() const { return *simulation_; }
    const RunRecorders& recorders() const { return recorders_; }
    double wall_seconds() const { return clock_.wall(); }  // of this and the runs it resumed
    double cpu_seconds() const { return clock_.cpu(); }

  private:
    RunEnd go();
    bool reached(double mark) const;
    void announce_step(bool checkpoint) const;
    void checkpoint();
    void archive(Archive& a);

    RunOptions options_;
    double end_;  // mark at which the scene ends
    std::unique_ptr<Simulation> simulation_;
    RunRecorders recorders_;
    RunCheckpoint checkpoint_;
    RunClock clock_;
};

}  // namespace sandgraph::simulation
