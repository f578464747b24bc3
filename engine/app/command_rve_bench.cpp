#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "app/command_rve.hpp"
#include "app/load_packing.hpp"
#include "app/make_assembly.hpp"
#include "app/prepare_packing.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string packing;
    int grains = 400, steps = 20000;
    bool reference = false;
};

constexpr double time_step = 1e-5;  // [s]

Mat2 simple_shear(double rate) { return (Mat2() << 0, rate, 0, 0).finished(); }

double seconds_of(dem::Assembly& assembly, const Mat2& L, int steps) {
    const auto start = std::chrono::steady_clock::now();
    assembly.step(L, time_step, steps);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Without a file: the dense packing of Table 1, made on the spot.
io::PackingRecord packing_of(const Options& options) {
    if (!options.packing.empty()) return load_packing(options.packing);
    scene::Grains grains;
    grains.count = options.grains;
    return {.packing = base_packing(grains), .material = grains.material, .recipe = {}};
}

void run(const Options& options) {
    const io::PackingRecord record = packing_of(options);
    const auto kernel = options.reference ? scene::Kernel::reference : scene::Kernel::fast;
    const auto assembly = make_assembly(kernel, record.packing, record.material);
    const Mat2 L = simple_shear(0.4);
    assembly->step(L, time_step, std::max(1, options.steps / 10));  // caches and contacts warm
    const double seconds = seconds_of(*assembly, L, options.steps);
    fmt::print("us_per_step {:.3f} contacts {}\n", 1e6 * seconds / options.steps,
               assembly->observe().contacts);
}

}  // namespace

void add_rve_bench(CLI::App& rve) {
    CLI::App* bench = rve.add_subcommand("bench", "time of a DEM step on one core, in simple shear");
    auto options = std::make_shared<Options>();
    bench->add_option("--packing", options->packing,
                      "packing, .csv or .h5 (default: a dense one made on the spot)");
    bench->add_option("--grains", options->grains, "of the packing made on the spot")
        ->check(CLI::Range(20, 65000));
    bench->add_option("--steps", options->steps, "DEM steps to time")->check(CLI::PositiveNumber);
    bench->add_flag("--reference", options->reference, "the published step instead of the optimised kernel");
    bench->callback([options] { run(*options); });
}

}  // namespace sandgraph::app
