#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/positive.hpp"
#include "app/simulate.hpp"

namespace sandgraph::app {

void add_run_command(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<RunRequest>();
    CLI::App* command = app.add_subcommand("run", "simulates one scene");
    command->add_option("scene", a->scene, "TOML file; `sandgraph keys` lists its keys")->required();
    command->add_option("-o,--out", a->folder, "run folder (default: out/<name of the scene file>)");
    command->add_option("--mode", a->mode, "full or screening, instead of the scene's");
    command->add_option("--set", a->set, "section.key=value, instead of the scene's; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--threads", a->threads, "default: all cores")->check(CLI::Range(1, 1024));
    command->add_option("--until", a->until, "stop at this d/B")->check(positive());
    command->add_flag("--resume", a->resume, "go on from the folder's last checkpoint");
    command->callback([a, &exit_code] { exit_code = simulate(*a); });
}

}  // namespace sandgraph::app
