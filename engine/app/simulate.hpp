#pragma once
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace sandgraph::app {

// What `sandgraph run` is asked for.
struct RunRequest {
    std::string scene, folder, mode;  // files; mode "": the scene's
    std::vector<std::string> set;     // section.key=value
    int threads = 0;                  // 0: all cores
    bool resume = false;
    double until = 0;  // d/B at which to stop; 0: the scene's end
};

int threads_of(const RunRequest& request);

// The checked scene of a request, with the surrogate's file found.
scene::Scene scene_of(const RunRequest& request);

// Runs it with all its outputs; returns the exit code.
int simulate(const RunRequest& request);

}  // namespace sandgraph::app
