#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "io/run_file.hpp"
#include "simulation/background_writer.hpp"
#include "simulation/build_pull.hpp"
#include "simulation/history_recorder.hpp"
#include "simulation/load_recorder.hpp"
#include "simulation/region_recorder.hpp"

namespace sandgraph::simulation {

struct RunOptions {
    std::filesystem::path folder;
    int threads = 0;
    double until = 0;  // d/B at which to stop
    bool resume = false;
};

enum class RunEnd { finished, interrupted };

// One simulation with its outputs: runs the pull, records loads and frames, keeps checkpoints.
class RunSession {
  public:
    // Makes (or, resuming, opens) the run folder: call it when all input is checked.
    RunSession(const scene::Scene& scene, const packings::PreparedGround& ground, const RunOptions& options);
    RunEnd run();
    // Once every output of a pull that went all the way is written: there is nothing left to resume. Before,
    // a kill would lose what was not written yet.
    void discard_restart_files();
    bool went_all_the_way() const;

    const graph::Pull& pull() const { return *pull_; }
    const io::RunRecord& record() const { return file_.record(); }
    const LoadRecorder& loads() const { return loads_; }
    const std::optional<HistoryRecorder>& history() const { return history_; }
    double wall_seconds() const;  // of this and the runs it resumed
    double cpu_seconds() const;
    std::filesystem::path frame_file() const { return file_.path(); }

  private:
    void after_step();
    void record_frame();
    void skip_frames();
    void checkpoint();
    void wind_up();
    void note_costs();
    void archive(Archive& a);
    void resume();

    scene::Scene scene_;
    RunOptions options_;
    std::unique_ptr<graph::Pull> pull_;
    std::vector<Vec2> start_;      // points before the first step
    double initial_porosity_ = 0;  // for laws without grains
    LoadRecorder loads_;
    RegionRecorder regions_;
    io::RunFile file_;
    std::optional<HistoryRecorder> history_;  // where the scene asks for it
    std::size_t next_frame_ = 0;
    double last_load_ = 0;
    std::map<std::string, double> timing_before_;  // phase -> wall time of the runs resumed [s]
    double wall_before_ = 0, cpu_before_ = 0, wall_start_ = 0, cpu_start_ = 0, last_checkpoint_ = 0;
    BackgroundWriter writer_;  // last: it must stop before what its jobs use
};

}  // namespace sandgraph::simulation
