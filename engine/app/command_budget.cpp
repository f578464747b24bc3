#include <CLI/CLI.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "base/console.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "report/budget_picture.hpp"
#include "report/run_pictures.hpp"
#include "results/budget_study.hpp"

namespace sandgraph::app {
namespace {

int tell_budget(const results::BudgetRequest& request) {
    const std::filesystem::path folder = request.run.folder;
    const io::FolderLock owner(folder);
    const auto budget = results::budget(request);
    if (!budget) {
        notice("stopped; the same command goes on");
        return exit_stopped_early;
    }
    io::write_text(folder / "budget.json", results::to_json(*budget));
    tell(results::budget_text(*budget));
    const report::Picture drawn = report::draw_budget_picture(
        *budget, "Load and its errors: " + results::title_of(simulation::scene_of(request.run)),
        folder / "budget.png");
    tell(drawn.drawn ? "results in " + folder.string() + "\n" : "no picture: " + drawn.message + "\n");
    return exit_done;
}

}  // namespace

void add_budget_command(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<results::BudgetRequest>();
    CLI::App* command = app.add_subcommand(
        "budget", "the breakout load with its errors: packings, mesh, rate of pull, surrogate");
    command->add_option("scene", a->run.scene, "TOML file")->required();
    command->add_option("-o,--out", a->run.folder, "folder of all runs, budget.json and budget.png")
        ->required();
    command->add_option("--mode", a->run.mode, "full or screening, instead of the scene's");
    command->add_option("--samples", a->samples, "packings drawn on coarse cells (default: 4)")
        ->check(CLI::Range(2, 100));
    command->add_option("--set", a->run.set, "section.key=value for all runs; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--threads", a->run.threads, "default: all cores")->check(CLI::Range(1, 1024));
    a->draw = [](const results::FinishedRun& run) {
        return report::draw_pictures(run.folder / "pictures", run);
    };
    command->callback([a, &exit_code] { exit_code = tell_budget(*a); });
}

}  // namespace sandgraph::app
