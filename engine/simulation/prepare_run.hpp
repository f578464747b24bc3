#pragma once
#include "packings/in_situ.hpp"
#include "simulation/run_request.hpp"

// What a run needs before its first step. What can be refused is refused before minutes of preparation.
namespace sandgraph::simulation {

// How the scene is to be run, and the run's folder taken into possession. InputError where it does not fit:
// another run has it, it cannot be written, it holds files of somebody else; a checkpoint to be
// resumed is damaged or of another scene. To resume starts where there is none, and finds a finished run
// finished, so that a job may be queued again whatever became of it. Without --resume an unfinished run,
// hours of work, is not written over.
RunOptions options_of(const RunRequest& request, const scene::Scene& scene);

// The packings, and the surrogate of a screening run. InputError for a surrogate that cannot be
// used, for more ground than the machine holds (a misplaced unit), for a plate too fast. Tells what the run
// will take.
packings::PreparedGround prepare(const scene::Scene& scene, int threads);
// The same unchecked and without a word.
packings::PreparedGround prepare_quietly(const scene::Scene& scene, const ProgressCallback& progress = {});

// InputError where the scene leaves a process of the crew without a packing.
void require_work_for(const Crew& crew, const scene::Scene& scene);

}  // namespace sandgraph::simulation
