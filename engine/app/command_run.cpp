#include <CLI/CLI.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/positive.hpp"
#include "base/console.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "report/run_pictures.hpp"
#include "results/packing_samples.hpp"
#include "results/run_scene.hpp"

namespace sandgraph::app {
namespace {

std::string draw(const results::FinishedRun& run) {
    return report::draw_pictures(run.folder / "pictures", run);
}

int run(const simulation::RunRequest& request) {
    return results::run_scene(request, draw) == simulation::RunEnd::finished ? exit_done : exit_stopped_early;
}

int run_sampled(const simulation::RunRequest& request, int count) {
    if (request.folder.empty())
        throw InputError({"sandgraph run", 0}, "--samples", "its runs need a folder of their own",
                         "name one with -o");
    const io::FolderLock owner(request.folder);
    const auto samples = results::run_samples(request, count, draw);
    if (!samples) {
        notice("stopped; the same command goes on");
        return exit_stopped_early;
    }
    io::write_text(std::filesystem::path(request.folder) / "samples.csv", results::to_csv(*samples));
    tell(results::samples_text(*samples));
    return exit_done;
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code, std::shared_ptr<simulation::Crew> crew) {
    auto a = std::make_shared<simulation::RunRequest>();
    a->crew = std::move(crew);
    CLI::App* command = app.add_subcommand("run", "simulates one scene");
    command->add_option("scene", a->scene, "TOML file; `sandgraph keys` lists its keys")->required();
    command->add_option("-o,--out", a->folder, "run folder (default: out/<name of the scene file>)");
    command->add_option("--mode", a->mode, "full or screening, instead of the scene's");
    command->add_option("--set", a->set, "section.key=value, instead of the scene's; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--threads", a->threads, "default: all cores")->check(CLI::Range(1, 1024));
    CLI::Option* until =
        command->add_option("--until", a->until, "stop at this d/B (without an anchor at this time, in s)")
            ->check(positive());
    command->add_flag(
        "--resume", a->resume,
        "go on from the folder's last checkpoint; start where there is none, leave a finished run");
    auto samples = std::make_shared<int>(0);
    command
        ->add_option("--samples", *samples,
                     "this many base packings, one after the other, with mean and interval")
        ->check(CLI::Range(2, 1000))
        ->excludes(until);
    command->callback(
        [a, samples, &exit_code] { exit_code = *samples > 0 ? run_sampled(*a, *samples) : run(*a); });
}

}  // namespace sandgraph::app
