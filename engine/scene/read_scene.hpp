#pragma once
#include <span>
#include <string>

#include "scene/scene.hpp"

namespace sandgraph::scene {

// Reads and checks a scene. Each override is "section.key=value" and passes the same checks. Throws
// InputError at the first thing that is wrong; on return the scene is complete, in SI, and geometrically
// possible.
Scene read_scene(const std::string& file, std::span<const std::string> overrides = {});

// The same from the text of a scene, as a run file keeps it; `file` only names it (and relative paths in it).
Scene parse_scene(const std::string& text, const std::string& file,
                  std::span<const std::string> overrides = {});

// The scene of a run that is over; the files that it read may have moved since.
Scene recorded_scene(const std::string& text, const std::string& name);

}  // namespace sandgraph::scene
