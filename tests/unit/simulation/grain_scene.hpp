#pragma once
#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "packings/in_situ.hpp"
#include "scene/read_scene.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::test {

// A shallow plate in a few rows of small packings, as a scene file says it; `more`: further tables.
inline std::string grain_scene(double depth, const std::string& more) {
    return fmt::format(R"(
[domain]
width = "2 m"
depth = "{} m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.03
{})",
                       depth, more);
}

// Its packings, made anew: in a cache that goes with this call.
inline packings::PreparedGround freshly_prepared(const scene::Scene& scene) {
    const Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    return packings::prepare_ground(scene);
}

}  // namespace sandgraph::test
