#pragma once
#include <filesystem>

#include "app/run_session.hpp"

namespace sandgraph::app {

// load.png and, for every frame, displacement, strain, rotation and porosity pictures in FOLDER/pictures.
// Returns a line for the user: what was drawn, or why not.
std::string draw_pictures(const std::filesystem::path& folder, const RunSession& session,
                          const scene::Scene& scene, const PreparedGround& ground);

}  // namespace sandgraph::app
