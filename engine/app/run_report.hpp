#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/finished_run.hpp"

namespace sandgraph::app {

// Every finished run in the folders: a folder itself, or those below it. InputError when there is none.
std::vector<FinishedRun> find_runs(const std::vector<std::string>& folders);

// The page's chapter on one run: figures, pictures (drawn into `pictures`), cost, scene. HTML.
std::string run_chapter(const FinishedRun& run, const std::filesystem::path& pictures);

// The chapter that sets the runs side by side: table, load curves, breakout factor against embedment.
std::string comparison_chapter(const std::vector<FinishedRun>& runs, const std::filesystem::path& pictures);

}  // namespace sandgraph::app
