#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/command_rve.hpp"
#include "base/console.hpp"
#include "base/file_name.hpp"
#include "base/revision.hpp"
#include "io/atomic_file.hpp"
#include "laboratory/element_test.hpp"
#include "packings/base_packing.hpp"
#include "packings/packing_material.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string test, packing, out;
    int threads = 1;
};

std::string metadata(const Options& options) {
    return nlohmann::json{{"test", options.test}, {"packing", options.packing}, {"git", revision()}}.dump();
}

// The test's own [grains] stand over the packing's, which a .csv does not have.
void tell_of_other_material(const Options& options, const dem::Material& used,
                            const dem::Material& of_packing) {
    if (!packings::has_material(options.packing)) return;
    const std::string other = packings::changed_material(used, of_packing);
    if (!other.empty()) notice(fmt::format("{}: {}", options.test, other));
}

void run(const Options& options) {
    require_extension(options.out, ".csv"), io::require_writable_file(options.out);
    const io::PackingRecord record = packings::load_packing(options.packing);
    const scene::ElementTestSpec spec = scene::read_element_test(options.test, record.material);
    tell_of_other_material(options, spec.material, record.material);
    const laboratory::ElementOutcome outcome =
        laboratory::run_element_test(spec, record.packing, metadata(options));
    if (options.out.empty()) {
        fmt::print("{}", outcome.csv);
        return;
    }
    io::write_text(options.out, outcome.csv);
    fmt::print("{}: {}\n", options.out, outcome.told);
}

}  // namespace

void add_rve_test(CLI::App& rve) {
    CLI::App* test = rve.add_subcommand("test", "an element test on one packing");
    auto options = std::make_shared<Options>();
    test->add_option("test", options->test,
                     "TOML file: kind = \"path\", \"biaxial\", \"isotropic\" or \"simple_shear\"")
        ->required();
    test->add_option("--packing", options->packing, "packing to test, .csv or .h5")->required();
    test->add_option("-o,--out", options->out, "CSV file to write (default: the terminal)");
    test->add_option("--threads", options->threads,
                     "taken for scripts' sake: one packing is one thread's work")
        ->check(CLI::Range(1, 1024));
    test->callback([options] { run(*options); });
}

}  // namespace sandgraph::app
