#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "io/load_csv.hpp"
#include "io/run_record.hpp"

namespace sandgraph::io {

// Removes what only a resumed run needs: the checkpoints, then the history journal that they count on, so
// that a kill in between leaves a run that can be resumed or one that has ended.
void remove_restart_files(const std::filesystem::path& folder);

// InputError when the folder holds a file of an output's name that no run of this program has left there: a
// run would write over it.
void require_own_outputs(const std::filesystem::path& folder);

// The growing outputs of a run folder: run.h5, load.csv, regions.csv, fields.xdmf. HDF5 cannot survive a kill
// in mid-write, so run.h5 is never edited in place: commit() assembles it beside it (frames on disk are
// copied over raw), brings it to the disk and renames it. Whenever the run is killed, run.h5 is the whole
// file of the last commit and load.csv has every row.
class RunFile {
  public:
    // A new run; call it only when all input is checked. Outputs of an earlier run in the folder are
    // replaced. `load_audited`: RunRecord::load_audited.
    static RunFile create(const std::filesystem::path& folder, const RunInfo& info,
                          bool load_audited = false);
    // Goes on with the run in the folder; archive() with the checkpoint's reader must follow. InputError when
    // its scene is another.
    static RunFile resume(const std::filesystem::path& folder, const RunInfo& info);

    void append(const LoadRow& row);  // to load.csv at once, to run.h5 at the next commit
    void append(const Frame& frame);  // commits
    // The regions that are followed, before any row of theirs. InputError when the run to resume has others.
    void follow(const std::vector<RegionSeries>& regions);
    void append(const std::vector<RegionRow>& rows);  // one a region; kept at the next commit
    void set_timing(const std::string& phase, double seconds) { record_.timing[phase] = seconds; }
    void set_counter(const std::string& name, double value) { record_.counters[name] = value; }
    void set_screening(ScreeningRecord screening) { record_.screening = std::move(screening); }
    void commit();

    // Writing a checkpoint: commits and notes the lengths of load series and frames. Reading: cuts both back
    // to the checkpoint's moment, so that a resumed run ends with the outputs of an uninterrupted one.
    void archive(Archive& a);

    const RunRecord& record() const { return record_; }
    std::filesystem::path path() const;  // of run.h5

  private:
    RunFile(std::filesystem::path folder, RunRecord record);
    void rewrite_csv();
    struct Extent {
        std::size_t load, frames, regions;  // rows
    };
    void cut_back(const Extent& to, const Extent& from);

    std::filesystem::path folder_;
    RunRecord record_;
    std::vector<Frame> pending_;  // not yet in run.h5
    std::optional<LoadCsv> csv_;  // opened by the first row, so that a refused resume leaves load.csv alone
};

}  // namespace sandgraph::io
