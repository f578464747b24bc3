#pragma once
#include "simulation/sweep_plan.hpp"

namespace sandgraph::simulation {

struct QueueOptions {
    int jobs = 1;     // runs at once
    int threads = 1;  // of each
};

struct QueueEnd {
    std::size_t finished = 0, failed = 0, stopped = 0;  // of those that were to run
    bool interrupted = false;  // asked to stop: those that had not begun are stopped, too
};

// Runs `runs` as child processes of this program, `jobs` at once, in their order. Each goes on from its
// checkpoint, what it tells goes to its log. One that fails is told, and the others go on. Asked to stop
// (Ctrl-C), it asks the children and waits for their checkpoints.
QueueEnd run_queue(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                   const QueueOptions& options);

}  // namespace sandgraph::simulation
