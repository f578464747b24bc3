#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <thread>

#include "app/command_rve.hpp"
#include "base/console.hpp"
#include "base/file_name.hpp"
#include "io/atomic_file.hpp"
#include "io/history.hpp"
#include "io/history_file.hpp"
#include "laboratory/probe.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string recipe, out;
    int threads = static_cast<int>(std::thread::hardware_concurrency());
};

void probe(const scene::ProbeSpec& spec, const Options& options) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(options.threads));
    StageProgress progress;
    laboratory::write_probe(spec, options.out,
                            [&progress](std::string_view stage, double f) { progress.update(stage, f); });
}

void run(const Options& options) {
    const scene::ProbeSpec spec = scene::read_probe(options.recipe);
    require_extension(options.out, ".h5"), io::require_writable_file(options.out);
    const double start = wall_clock();
    probe(spec, options);
    fmt::print("{}: {:.0f} s\n{}", options.out, wall_clock() - start,
               io::history_overview(io::read_history(options.out)));
}

}  // namespace

void add_rve_probe(CLI::App& rve) {
    CLI::App* probe = rve.add_subcommand(
        "probe", "drives packings along random strain paths: a training set without a run");
    auto options = std::make_shared<Options>();
    probe->add_option("recipe", options->recipe, "TOML file; `sandgraph keys probe` lists its keys")
        ->required();
    probe->add_option("-o,--out", options->out, "history log to write, HDF5")->required();
    probe->add_option("--threads", options->threads, "default: all cores")->check(CLI::Range(1, 1024));
    probe->callback([options] { run(*options); });
}

}  // namespace sandgraph::app
