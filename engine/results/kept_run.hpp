#pragma once
#include <optional>

#include "results/run_scene.hpp"

namespace sandgraph::results {

// The run of a study, in its folder. Read where this program has finished it on as many threads, gone on with
// where it was stopped, else made now. Empty when it was stopped again.
std::optional<FinishedRun> kept_run(simulation::RunRequest request, const DrawPictures& draw);

}  // namespace sandgraph::results
