#pragma once
#include "packings/in_situ.hpp"
#include "simulation/run_request.hpp"

// What a run needs before its first step. What can be refused is refused before minutes of preparation.
namespace sandgraph::simulation {

// How the scene is to be run. InputError where the folder does not fit: to resume it needs a whole
// checkpoint of this scene; started anew, an unfinished run is hours of work and is not written over by a
// forgotten --resume.
RunOptions options_of(const RunRequest& request, const scene::Scene& scene);

// The packings, and the surrogate of a screening run. InputError for a folder that cannot be written, for a
// surrogate that cannot be used, for more ground than the machine holds (a misplaced unit).
packings::PreparedGround prepare(const scene::Scene& scene, const std::filesystem::path& folder);

}  // namespace sandgraph::simulation
