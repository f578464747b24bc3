#pragma once
#include <map>
#include <optional>
#include <string>

#include "io/run_file.hpp"
#include "simulation/background_writer.hpp"
#include "simulation/frame_recorder.hpp"
#include "simulation/history_recorder.hpp"
#include "simulation/load_recorder.hpp"
#include "simulation/region_recorder.hpp"
#include "simulation/run_request.hpp"

namespace sandgraph::simulation {

// What a run leaves in its folder: loads, frames, regions, the history log, and run.h5 that holds them. Rows
// and frames are written by a thread of its own.
class RunRecorders {
  public:
    // Makes (or, resuming, opens) the run folder: call it when all input is checked. `simulation`: at rest.
    RunRecorders(const scene::Scene& scene, const packings::PreparedGround& ground, Simulation& simulation,
                 const RunOptions& options);
    void after_step(const Simulation& simulation);
    // Whether something that looks at packings falls due up to this mark.
    bool look_by(double mark) const;
    // Waits for the writer and notes what the law and the phases have cost so far. Before commit or archive.
    void settle(const Simulation& simulation);
    void commit() { file_.commit(); }
    void write_history();
    // After the simulation's own part. run.h5 comes last: it is cut back to the checkpoint, and whatever is
    // refused before leaves the folder alone.
    void archive(Archive& a, const Simulation& simulation);

    const io::RunRecord& record() const { return file_.record(); }
    const LoadRecorder& loads() const { return loads_; }
    const std::optional<HistoryRecorder>& history() const { return history_; }
    std::filesystem::path frame_file() const { return file_.path(); }

  private:
    std::filesystem::path folder_;
    LoadRecorder loads_;
    FrameRecorder frames_;
    RegionRecorder regions_;
    io::RunFile file_;
    std::optional<HistoryRecorder> history_;       // where the scene asks for it
    std::map<std::string, double> timing_before_;  // phase -> wall time of the runs resumed [s]
    BackgroundWriter writer_;                      // last: it must stop before what its jobs use
};

}  // namespace sandgraph::simulation
