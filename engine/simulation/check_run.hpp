#pragma once
#include <filesystem>

#include "scene/scene.hpp"

// What a run needs, looked at before minutes of preparation; InputError where it is not so.
namespace sandgraph::simulation {

// To resume: a whole checkpoint of this scene.
void require_checkpoint(const std::filesystem::path& folder, const scene::Scene& scene);

// To start anew: an unfinished run is hours of work and is not written over by a forgotten --resume.
void require_no_checkpoint(const std::filesystem::path& folder);

// A misplaced unit asks for more ground than any machine holds.
void require_memory(const scene::Scene& scene);

}  // namespace sandgraph::simulation
