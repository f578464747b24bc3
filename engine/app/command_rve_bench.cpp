#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>

#include "app/command_rve.hpp"
#include "base/error.hpp"
#include "dem/fast/kernel.hpp"
#include "dem/grain_scale.hpp"
#include "dem/make_assembly.hpp"
#include "packings/base_packing.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string packing;
    int grains = 400, steps = 20000;
    bool reference = false, growth = false;
    std::string target, kernel = "double";
};

Mat2 simple_shear(double rate) { return (Mat2() << 0, rate, 0, 0).finished(); }

// Processor time of this thread, so that other programs on the machine count little.
double seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Without a file: the dense packing of Table 1, made on the spot.
io::PackingRecord packing_of(const Options& options) {
    if (!options.packing.empty()) return packings::load_packing(options.packing);
    scene::Grains grains;
    grains.count = options.grains;
    return {.packing = packings::base_packing(grains), .material = grains.material, .recipe = {}};
}

dem::Kernel kernel_of(const Options& options) {
    if (options.reference) return dem::Kernel::reference;
    return options.kernel == "mixed" ? dem::Kernel::mixed : dem::Kernel::fast;
}

// Time of a DEM step [us]; the contacts at its end.
std::pair<double, int> measure(const Options& options, const io::PackingRecord& record, int steps) {
    const auto assembly = dem::make_assembly(kernel_of(options), record.packing, record.material);
    const dem::GrainScale grains = dem::grain_scale(record.packing, record.material);
    const double time_step = grains.time_step;
    const Mat2 L = simple_shear(0.4 / grains.slowness);
    assembly->step(L, time_step, std::max(1, steps / 10));  // caches and contacts warm
    const double start = seconds();
    assembly->step(L, time_step, steps);
    return {1e6 * (seconds() - start) / steps, static_cast<int>(assembly->observe().contacts)};
}

// Both kernels in turn, so that what else the machine does falls on both; medians of the rounds.
void print_both(Options options) {
    constexpr int rounds = 9;
    const io::PackingRecord record = packing_of(options);
    std::vector<double> of_double, of_mixed;
    for (int round = 0; round < rounds; ++round) {
        options.kernel = "double", of_double.push_back(measure(options, record, options.steps).first);
        options.kernel = "mixed", of_mixed.push_back(measure(options, record, options.steps).first);
    }
    const auto median = [](std::vector<double>& times) {
        std::ranges::nth_element(times, times.begin() + rounds / 2);
        return times[rounds / 2];
    };
    const double slow = median(of_double), fast = median(of_mixed);
    fmt::print("us_per_step double {:.3f} mixed {:.3f} ratio {:.3f}\n", slow, fast, slow / fast);
}

void print(const Options& options) {
    if (options.kernel == "both") return print_both(options);
    const auto [us, contacts] = measure(options, packing_of(options), options.steps);
    fmt::print("us_per_step {:.3f} contacts {}\n", us, contacts);
}

// Sizes in turn, the same number of grain steps each; the best of the rounds, since a shared machine only
// adds to a time of hundredths of a second.
void print_growth(Options options) {
    constexpr int sizes[] = {100, 400, 1600, 10000}, rounds = 9;
    std::vector<io::PackingRecord> packings;
    for (const int grains : sizes) options.grains = grains, packings.push_back(packing_of(options));
    std::vector<double> best(packings.size(), 1e300);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < packings.size(); ++k) {
            const int steps = std::max(1, options.steps * 400 / sizes[k]);
            best[k] = std::min(best[k], measure(options, packings[k], steps).first);
        }
    fmt::print(" grains  us_per_step  ns_per_grain_step  against_100_grains\n");
    for (std::size_t k = 0; k < best.size(); ++k)
        fmt::print("{:7d}  {:11.3f}  {:17.2f}  {:18.3f}\n", sizes[k], best[k], 1e3 * best[k] / sizes[k],
                   best[k] / sizes[k] * sizes[0] / best[0]);
}

void print_targets(const Options& options) {
    for (const std::string& target : dem::kernel_targets()) {
        dem::use_kernel_target(target);
        fmt::print("{:8} ", target);
        print(options);
    }
}

void run(const Options& options) {
    if (options.growth && options.kernel == "both")
        throw InputError({"rve bench", 0}, "--growth with --kernel both", "growth is of one kernel",
                         "write --kernel double or --kernel mixed");
    if (options.growth) return print_growth(options);
    if (options.target == "all") return print_targets(options);
    if (!options.target.empty()) dem::use_kernel_target(options.target);
    print(options);
}

}  // namespace

void add_rve_bench(CLI::App& rve) {
    CLI::App* bench = rve.add_subcommand("bench", "time of a DEM step on one core, in simple shear");
    auto options = std::make_shared<Options>();
    CLI::Option* packing = bench->add_option("--packing", options->packing,
                                             "packing, .csv or .h5 (default: a dense one made on the spot)");
    CLI::Option* grains = bench->add_option("--grains", options->grains, "of the packing made on the spot");
    grains->check(CLI::Range(20, 65000))->excludes(packing);
    bench->add_option("--steps", options->steps, "DEM steps to time")->check(CLI::Range(1, 1000000000));
    CLI::Option* reference = bench->add_flag("--reference", options->reference,
                                             "the published step instead of the optimised kernel");
    bench
        ->add_option("--kernel", options->kernel,
                     "precision of the optimised kernel: double, mixed, or both in turn")
        ->check(CLI::IsMember({"double", "mixed", "both"}))
        ->excludes(reference);
    CLI::Option* growth = bench->add_flag("--growth", options->growth,
                                          "time against the number of grains: 100, 400, 1600, 10000");
    growth->excludes(packing, grains);
    std::vector<std::string> targets = dem::kernel_targets();
    targets.push_back("all");
    bench
        ->add_option("--target", options->target,
                     "instruction set of the kernel (default: the widest), or all")
        ->check(CLI::IsMember(targets))
        ->excludes(reference, growth);
    bench->callback([options] { run(*options); });
}

}  // namespace sandgraph::app
