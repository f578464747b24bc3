#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "report/region_picture.hpp"
#include "results/finished_run.hpp"

namespace sandgraph::report {

// What a run tells across the scales, as HTML: its regions, their stress paths, the packings it kept, and how
// far its failure reaches. Pictures go to `pictures`. Empty for a run that kept nothing of it.
std::string cross_scale_chapter(const results::FinishedRun& run, const std::filesystem::path& pictures,
                                const std::optional<report::CriticalLines>& critical);

}  // namespace sandgraph::report
