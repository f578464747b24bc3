#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "scene/sweep_rows.hpp"
#include "simulation/estimate.hpp"
#include "simulation/run_request.hpp"

namespace sandgraph::simulation {

// One run of a sweep: a sample of a row.
struct SweepRun {
    std::size_t row = 0;
    int sample = 1;  // from 1 on
    RunRequest request;
    scene::Scene scene;
    std::string scene_hash;
    Estimate estimate;  // on one thread

    std::filesystem::path folder() const { return request.folder; }
    // Beside the folder, which is the run's own.
    std::filesystem::path log() const { return request.folder + ".log"; }         // all that it told
    std::filesystem::path failure() const { return request.folder + ".failed"; }  // one line, while it stands
};

// A table with all its runs, row by row, sample by sample: rows/NAME/K in the sweep's folder.
struct SweepPlan {
    scene::SweepTable table;
    std::filesystem::path folder;
    std::vector<SweepRun> runs;

    std::string name(const SweepRun& run) const;  // "embedment_ratio=2/1"
};

// Reads the table and checks the scene of every run. Throws InputError before anything is made.
SweepPlan plan_sweep(const std::string& file, const std::filesystem::path& folder);

// How a run stands, by its folder. InputError where that holds a finished run of another scene.
enum class RunState { waiting, stopped, failed, finished };
RunState state_of(const SweepRun& run);

// Those that have not finished, in order.
std::vector<const SweepRun*> unfinished(const SweepPlan& plan);

// How many of these runs the memory holds at once, whichever they are; at least 1.
int room_for(const std::vector<const SweepRun*>& runs);

// InputError where `jobs` of them may take more memory than there is.
void require_room(const std::vector<const SweepRun*>& runs, int jobs);

}  // namespace sandgraph::simulation
