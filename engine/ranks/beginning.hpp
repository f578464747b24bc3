#pragma once
#include "ranks/team.hpp"
#include "simulation/run_request.hpp"

namespace sandgraph::ranks {

// What the other ranks must know of a run to compute its steps.
struct Beginning {
    simulation::RunRequest request;  // scene, mode, overrides
    std::string folder, scene_hash;
    int threads = 1;
    bool resume = false;  // there is a checkpoint in the folder
    double until = 0;     // mark at which the run ends
};

Bytes packed(const Beginning& run);
Beginning unpacked(ByteSpan bytes);

}  // namespace sandgraph::ranks
