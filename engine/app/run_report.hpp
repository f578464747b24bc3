#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/finished_run.hpp"
#include "report/breakout_picture.hpp"
#include "report/region_picture.hpp"

namespace sandgraph::app {

// Every finished run in the folders: a folder itself, or those below it. InputError when there is none.
std::vector<FinishedRun> find_runs(const std::vector<std::string>& folders);

struct ChapterOptions {
    std::size_t frames_max =
        6;  // field pictures: the one nearest to the breakout, the last, others in between
    std::optional<report::CriticalLines> critical;
};

// The page's chapter on one run: figures, pictures (drawn into `pictures`), cost, scene. HTML.
std::string run_chapter(const FinishedRun& run, const std::filesystem::path& pictures,
                        const ChapterOptions& options);

// By anchor and sand: the runs that broke out, and the mean of the friction angles that are known.
std::vector<report::BreakoutSeries> breakout_series(const std::vector<FinishedRun>& runs);

// The chapter that sets the runs side by side: table, load curves, breakout factor against embedment.
std::string comparison_chapter(const std::vector<FinishedRun>& runs, const std::filesystem::path& pictures);

}  // namespace sandgraph::app
