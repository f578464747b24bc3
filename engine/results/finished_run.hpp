#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/run_record.hpp"
#include "io/summary.hpp"
#include "results/peak.hpp"
#include "scene/scene.hpp"

namespace sandgraph::results {

// A run as its folder keeps it, for whoever compares, reports or draws.
struct FinishedRun {
    std::filesystem::path folder;
    scene::Scene scene;
    io::RunRecord record;
    io::Summary summary;

    std::filesystem::path frame_file() const { return folder / "run.h5"; }
};

// "r1/" and "./r1" as "r1", "." by its own name: the last part names the run.
std::filesystem::path plain_folder(const std::filesystem::path& folder);

// InputError when the folder holds no finished run (run.h5 and summary.json).
FinishedRun read_finished_run(const std::filesystem::path& folder);

// Every finished run in the folders: a folder itself, or those below it. InputError when there is none.
std::vector<FinishedRun> find_runs(const std::vector<std::string>& folders);

// What a picture calls the run: its scene's title, else the name of the scene file.
std::string title_of(const scene::Scene& scene);

// H/B with the surcharge counted as depth.
double embedment_of(const FinishedRun& run);

// Of the ground before the pull [N/m3]; NaN where the summary does not tell it.
double unit_weight(const FinishedRun& run);

bool pulled_up(const scene::Scene& scene);  // horizontal plate

}  // namespace sandgraph::results
