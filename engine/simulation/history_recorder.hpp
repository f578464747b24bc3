#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "io/history_journal.hpp"
#include "packings/in_situ.hpp"
#include "scene/scene.hpp"
#include "simulation/background_writer.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::simulation {

// Chooses the points of the log and has the law watch them: all over the ground at full fidelity, the audited
// ones in a screening run. Returns the points. InputError for ground without grains.
std::vector<std::int32_t> watch_history(Simulation& simulation, const scene::Scene& scene);

// The history log of a run: follows some points (of a screening run the audited ones) from the first step on,
// hands their updates to the background writer in blocks, and makes history.h5 of them when the run ends.
// Bounded in memory by the writer's queue, on disk by [output] history_max, past which it logs no more.
class HistoryRecorder {
  public:
    // Watches the points of `pull`, at rest. InputError for ground without grains.
    HistoryRecorder(const scene::Scene& scene, const packings::PreparedGround& ground, Simulation& simulation,
                    std::filesystem::path folder, bool resume);
    void after_step(const Simulation& simulation, BackgroundWriter& writer);
    // With an idle writer only: what the checkpoint must know; reading cuts the journal back to it.
    void archive(Archive& a);
    // With an idle writer only: history.h5 of what was logged so far. The journal stays, for a resumed run.
    void write();

    std::size_t rows() const { return logged_; }
    bool full() const { return full_; }

  private:
    void log(const dem::RveUpdate& update, double time);
    void hand_over(BackgroundWriter& writer);
    std::filesystem::path journal_path() const { return folder_ / io::journal_name; }

    std::filesystem::path folder_;
    io::HistorySource source_;
    std::vector<io::HistoryPacking> packings_;
    std::vector<io::HistoryInfo> histories_;
    std::vector<std::int32_t> history_of_;  // by point, -1: not logged
    std::vector<std::int64_t> length_;      // by history: rows so far
    std::vector<double> last_time_;         // by history: of its last row [s]
    std::size_t logged_ = 0, rows_max_;
    bool full_ = false;
    io::HistoryMode mode_ = io::HistoryMode::dem;
    std::vector<io::HistoryRow> pending_;
    std::optional<io::HistoryJournal> journal_;
};

}  // namespace sandgraph::simulation
