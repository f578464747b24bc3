#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands.hpp"
#include "base/child_program.hpp"
#include "base/console.hpp"
#include "base/file_name.hpp"
#include "base/process.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "io/history_file.hpp"
#include "laboratory/probe.hpp"
#include "scene/train_spec.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::app {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string recipe, out, evaluate;
    bool ladder = false, measure = false;
};

// The trainer is a program of its own: libtorch costs every process that loads it a second and 160 MB.
fs::path trainer() {
    fs::path program = this_program().parent_path() / "sandgraph-train";
    if (!fs::exists(program))
        throw std::runtime_error(
            "training needs libtorch, which was missing when this was built; install the Debian package "
            "libtorch-dev and build again (./sandgraph train does both)");
    return program;
}

// The log of the recipe's probes, beside the model; made once for the same probe recipe.
std::string probe_log(const scene::TrainSpec& spec, const std::string& out) {
    if (spec.probe.empty()) return "";
    const fs::path log = fs::path(out).replace_extension(".probes.h5");
    const scene::ProbeSpec probe = scene::read_probe(spec.probe);
    if (fs::exists(log) && io::read_history_source(log).text == probe.text) return log.string();
    io::require_writable_file(log);
    const io::FolderLock owner(scene::training_folder(out));  // the trainer takes it over
    StageProgress progress;
    laboratory::write_probe(probe, log, progress.callback());
    return log.string();
}

void run(const Options& options) {
    const scene::TrainSpec spec = scene::read_train(options.recipe);
    require_extension(options.out, ".h5");
    const fs::path program = trainer();
    io::require_writable_file(options.out);
    if (!options.evaluate.empty()) surrogate::load_surrogate(options.evaluate);  // refused before the probes
    const std::string probes = probe_log(spec, options.out.empty() ? options.evaluate : options.out);
    std::vector<std::string> arguments{program.string(), options.recipe};
    if (!options.out.empty()) arguments.insert(arguments.end(), {"-o", options.out});
    if (!options.evaluate.empty()) arguments.insert(arguments.end(), {"--evaluate", options.evaluate});
    if (!probes.empty()) arguments.insert(arguments.end(), {"--probes", probes});
    if (options.measure) arguments.emplace_back("--measure");
    if (options.ladder) arguments.emplace_back("--ladder");
    become_program(std::move(arguments));
}

}  // namespace

void add_train_command(CLI::App& app, int&) {
    CLI::App* train = app.add_subcommand("train", "trains a surrogate from history logs and probes");
    auto options = std::make_shared<Options>();
    train->add_option("recipe", options->recipe, "TOML file; `sandgraph keys train` lists its keys")
        ->required();
    CLI::Option* out =
        train->add_option("-o,--out", options->out, "model to write, HDF5; its card and errors go beside it");
    CLI::Option* evaluate = train->add_option("--evaluate", options->evaluate,
                                              "model to measure on the held-out histories; trains nothing");
    evaluate->check(CLI::ExistingFile)->excludes(out);
    train->add_flag("--ladder", options->ladder, "train and measure every rung, not only the recipe's")
        ->excludes(evaluate);
    train->add_flag("--measure", options->measure,
                    "write the errors alone: for the baselines, and laws told less of their packings");
    train->callback([options] {
        if (options->out.empty() && options->evaluate.empty())
            throw CLI::RequiredError("one of --out and --evaluate");
        run(*options);
    });
}

}  // namespace sandgraph::app
