#include <CLI/CLI.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/positive.hpp"
#include "report/run_pictures.hpp"
#include "results/run_scene.hpp"

namespace sandgraph::app {
namespace {

int run(const simulation::RunRequest& request) {
    const auto draw = [](const results::FinishedRun& run) {
        return report::draw_pictures(run.folder / "pictures", run);
    };
    return results::run_scene(request, draw) == simulation::RunEnd::finished ? exit_done : exit_stopped_early;
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
    command->add_option("--until", a->until, "stop at this d/B (without an anchor at this time, in s)")
        ->check(positive());
    command->add_flag(
        "--resume", a->resume,
        "go on from the folder's last checkpoint; start where there is none, leave a finished run");
    command->callback([a, &exit_code] { exit_code = run(*a); });
}

}  // namespace sandgraph::app
