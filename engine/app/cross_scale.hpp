#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/finished_run.hpp"
#include "report/region_picture.hpp"

namespace sandgraph::app {

// What a run tells across the scales, as HTML: its regions, their stress paths, the packings it kept, and how
// far its failure reaches. Pictures go to `pictures`. Empty for a run that kept nothing of it.
std::string cross_scale_chapter(const FinishedRun& run, const std::filesystem::path& pictures,
                                const std::optional<report::CriticalLines>& critical);

}  // namespace sandgraph::app
