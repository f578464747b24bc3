#pragma once
#include "scene/scene.hpp"

// What a run will take, before anything of it is made.
namespace sandgraph::simulation {

struct Estimate {
    double points = 0, steps = 0;
    double bytes = 0;    // material points, and the packings of those that will have strained
    double seconds = 0;  // on `threads`; right within a factor of three
    double packings = 0,
           preparation = 0;  // in-situ packings, and the time to make them if none is cached [s]
};
Estimate estimate(const scene::Scene& scene, int threads);

// InputError for more ground than this machine (or its control group) holds, and for a plate too fast for
// contact to be followed.
void require_feasible(const scene::Scene& scene, const Estimate& estimate);

// The plate's travel in a step of `dt` [s] is bounded: faster, touches come and go between two looks at them.
// InputError.
void require_slow_plate(const scene::Scene& scene, double dt);

}  // namespace sandgraph::simulation
