#pragma once
#include "simulation/sweep_plan.hpp"

namespace sandgraph::simulation {

struct JobArray {
    std::string table;  // file of the sweep
    int threads = 1;    // of each run
};

// sweep.sbatch: one task of a Slurm job array a run, numbered from 1; a task that is stopped (time,
// preemption) writes its checkpoint and is queued again. Outside of Slurm a task runs with
// SLURM_ARRAY_TASK_ID=K alone.
std::string batch_script(const SweepPlan& plan, const JobArray& array);

// collect.sh: makes table, chart and page of what is there.
std::string collect_script(const SweepPlan& plan, const JobArray& array);

// Both, into the sweep's folder.
void write_job_array(const SweepPlan& plan, const JobArray& array);

}  // namespace sandgraph::simulation
