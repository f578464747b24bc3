#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "base/console.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "report/sweep_page.hpp"
#include "results/sweep_results.hpp"
#include "simulation/job_array.hpp"
#include "simulation/run_queue.hpp"

namespace sandgraph::app {
namespace {

using simulation::SweepPlan;
using Runs = std::vector<const simulation::SweepRun*>;

struct Arguments {
    std::string table, folder;
    int jobs = 0, threads = 0;  // 0: as many as fit; all cores
    bool slurm = false, collect = false, resume = false;
    int task = 0;  // 0: no task of a job array
};

int cores_of(const Arguments& a) {
    return a.threads > 0 ? a.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Asked for, or as many as there are cores and memory for.
int jobs_of(const Arguments& a, const Runs& runs) {
    if (a.jobs > 0) simulation::require_room(runs, a.jobs);
    const int jobs = a.jobs > 0 ? a.jobs : std::min(cores_of(a), simulation::room_for(runs));
    return std::clamp(jobs, 1, std::max(1, static_cast<int>(runs.size())));
}

void collect(const SweepPlan& plan) {
    const auto rows = results::sweep_results(plan);
    io::write_text(plan.folder / "table.csv", results::sweep_table_csv(plan, rows));
    io::write_text(plan.folder / "samples.csv", results::sweep_samples_csv(plan, rows));
    const std::string undrawn = report::write_sweep_page(plan, rows);
    tell(results::sweep_text(plan, rows));
    if (!undrawn.empty()) tell(undrawn + "\n");
    tell(fmt::format("table in {}\n", (plan.folder / "table.csv").string()));
}

std::string command_to_go_on(const Arguments& a) {
    std::string text = fmt::format("sandgraph sweep {} -o {}", simulation::shell_word(a.table),
                                   simulation::shell_word(a.folder));
    if (a.jobs > 0) text += fmt::format(" --jobs {}", a.jobs);
    if (a.threads > 0) text += fmt::format(" --threads {}", a.threads);
    return text + " --resume";
}

int code_of(const simulation::QueueEnd& end) {
    if (end.interrupted) return exit_stopped_early;
    if (end.failed > 0) return exit_failed;
    return end.stopped > 0 ? exit_stopped_early : exit_done;
}

int run_here(const Arguments& a, const SweepPlan& plan, const Runs& runs) {
    const int jobs = jobs_of(a, runs);
    const simulation::QueueEnd end =
        simulation::run_queue(plan, runs, {jobs, std::max(1, cores_of(a) / jobs)});
    collect(plan);
    if (end.failed > 0)
        notice(fmt::format("{} of {} runs failed; what they told is in {}", end.failed, plan.runs.size(),
                           (plan.folder / "rows/NAME/K.log").string()));
    if (code_of(end) != exit_done) notice("the sweep is not complete; go on with: " + command_to_go_on(a));
    return code_of(end);
}

int run_task(const Arguments& a, const SweepPlan& plan) {
    if (a.task > static_cast<int>(plan.runs.size()))
        throw InputError({"--task"}, std::to_string(a.task),
                         fmt::format("the sweep has {} runs", plan.runs.size()), "count from 1");
    const simulation::SweepRun& run = plan.runs[static_cast<std::size_t>(a.task) - 1];
    if (simulation::state_of(run) == simulation::RunState::finished) return exit_done;
    return code_of(simulation::run_queue(plan, {&run}, {1, cores_of(a)}));
}

int write_jobs(const Arguments& a, const SweepPlan& plan) {
    simulation::write_job_array(plan, {a.table, a.threads > 0 ? a.threads : 1});
    tell(fmt::format("{} runs: sbatch {}; afterwards: sh {}\n", plan.runs.size(),
                     (plan.folder / "sweep.sbatch").string(), (plan.folder / "collect.sh").string()));
    return exit_done;
}

int sweep(const Arguments& a) {
    const SweepPlan plan = simulation::plan_sweep(a.table, a.folder);
    if (a.task > 0) return run_task(a, plan);  // tasks share the folder; each run's own has one owner
    const Runs runs = simulation::unfinished(plan);
    if (!a.collect && !a.slurm) jobs_of(a, runs);  // refused before the folder is made
    const io::FolderLock owner(plan.folder);
    if (a.slurm) return write_jobs(a, plan);
    if (!a.collect) return run_here(a, plan, runs);
    collect(plan);
    return exit_done;
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("sweep", "a table of runs: values of any keys, several samples each");
    command->add_option("table", a->table, "TOML file; `sandgraph keys sweep` lists its keys")->required();
    command->add_option("-o,--out", a->folder, "folder of table.csv, index.html and all runs")->required();
    CLI::Option* jobs = command
                            ->add_option("--jobs", a->jobs,
                                         "runs at once (default: as many as there are cores and memory for)")
                            ->check(CLI::Range(1, 1024));
    command
        ->add_option("--threads", a->threads,
                     "shared out among the jobs (default: all cores); with --slurm of each run (default: 1)")
        ->check(CLI::Range(1, 1024));
    command->add_flag("--resume", a->resume, "go on with what has not finished, as it does without");
    CLI::Option* slurm =
        command->add_flag("--slurm", a->slurm, "run nothing: write sweep.sbatch, a job array, and collect.sh")
            ->excludes(jobs);
    CLI::Option* only =
        command->add_flag("--collect", a->collect, "run nothing: make table and page of what is there")
            ->excludes(jobs)
            ->excludes(slurm);
    command->add_option("--task", a->task, "run only the K-th run, as a task of a job array")
        ->check(CLI::PositiveNumber)
        ->excludes(jobs)
        ->excludes(slurm)
        ->excludes(only);
    command->callback([a, &exit_code] { exit_code = sweep(*a); });
}

}  // namespace sandgraph::app
