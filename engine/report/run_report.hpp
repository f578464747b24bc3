#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/breakout_picture.hpp"
#include "report/region_picture.hpp"
#include "results/finished_run.hpp"

namespace sandgraph::report {

struct ChapterOptions {
    std::size_t frames_max =
        6;  // field pictures: the one nearest to the breakout, the last, others in between
    std::optional<report::CriticalLines> critical;
};

// The page's chapter on one run: figures, pictures (drawn into `pictures`), cost, scene. HTML.
std::string run_chapter(const results::FinishedRun& run, const std::filesystem::path& pictures,
                        const ChapterOptions& options);

// What tables say of a screening run's gate and of its audit ("17.8 % ± 3.1 %"); "-" of another run.
std::string gate_text(const scene::Scene& scene);
std::string audit_text(const io::Summary& summary);

// By anchor and sand: the runs that broke out, and the mean of the friction angles that are known.
std::vector<report::BreakoutSeries> breakout_series(const std::vector<results::FinishedRun>& runs);

// The chapter that sets the runs side by side: table, load curves, breakout factor against embedment.
std::string comparison_chapter(const std::vector<results::FinishedRun>& runs,
                               const std::filesystem::path& pictures);

}  // namespace sandgraph::report
