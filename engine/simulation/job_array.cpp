#include "simulation/job_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/child_program.hpp"
#include "io/atomic_file.hpp"

namespace sandgraph::simulation {
namespace {

namespace fs = std::filesystem;

constexpr double kMargin = 1.5;  // of memory, over the estimate

std::string sweep_command(const SweepPlan& plan, const JobArray& array) {
    return fmt::format("{} sweep {} -o {}", shell_word(this_program().string()),
                       shell_word(fs::absolute(array.table).string()),
                       shell_word(fs::absolute(plan.folder).string()));
}

int megabytes(const SweepPlan& plan) {
    double most = 0;
    for (const SweepRun& run : plan.runs) most = std::max(most, run.estimate.bytes);
    return 500 + static_cast<int>(std::ceil(kMargin * most / 1e6));
}

// As the sweep was called: paths in the table may be relative.
std::string go_there() { return fmt::format("cd {}\n", shell_word(fs::current_path().string())); }

// The shell gets Slurm's signal and hands it on; it waits in the background, for a trap runs only then.
constexpr const char* kTask = R"(stopping=
stop() {{ stopping=1; kill -INT "$child" 2>/dev/null; }}
trap stop TERM INT
{command} --threads "${{SLURM_CPUS_PER_TASK:-{threads}}}" --task "$SLURM_ARRAY_TASK_ID" &
child=$!
wait "$child"; code=$?
[ -z "$stopping" ] || {{ wait "$child"; code=$?; }} # the first was cut short by the signal
# 3: stopped, can go on
if [ "$code" = 3 ] && [ -n "${{SLURM_ARRAY_JOB_ID:-}}" ]; then
    scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
fi
exit "$code"
)";

}  // namespace

std::string batch_script(const SweepPlan& plan, const JobArray& array) {
    const std::string log = (fs::absolute(plan.folder) / "slurm-%A_%a.out").string();
    return fmt::format(
               "#!/bin/bash\n"
               "# {} runs of {}. Submit: sbatch sweep.sbatch; then, or in between: sh collect.sh.\n"
               "# Time and partition are this cluster's own: add #SBATCH lines, or give them to sbatch.\n"
               "#SBATCH --job-name=sweep\n#SBATCH --array=1-{}\n#SBATCH --ntasks=1\n"
               "#SBATCH --cpus-per-task={}\n#SBATCH --mem={}M\n#SBATCH --requeue\n"
               "#SBATCH --signal=B:TERM@120\n#SBATCH --output={}\n",
               plan.runs.size(), fs::path(array.table).filename().string(), plan.runs.size(), array.threads,
               megabytes(plan), log) +
           go_there() +
           fmt::format(fmt::runtime(kTask), fmt::arg("command", sweep_command(plan, array)),
                       fmt::arg("threads", array.threads));
}

std::string collect_script(const SweepPlan& plan, const JobArray& array) {
    return "#!/bin/sh\n" + go_there() + "exec " + sweep_command(plan, array) + " --collect\n";
}

void write_job_array(const SweepPlan& plan, const JobArray& array) {
    io::write_text(plan.folder / "sweep.sbatch", batch_script(plan, array));
    io::write_text(plan.folder / "collect.sh", collect_script(plan, array));
}

}  // namespace sandgraph::simulation
