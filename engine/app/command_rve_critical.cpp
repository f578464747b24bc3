#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/command_rve.hpp"
#include "base/console.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "laboratory/critical_table.hpp"
#include "report/critical_picture.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string folder = "out/critical";
    laboratory::CriticalPlan plan;
    std::vector<double> kilopascals;  // of plan.pressures
    Options() {
        for (const double p : plan.pressures) kilopascals.push_back(p / 1e3);
    }
};

std::vector<laboratory::CriticalTest> test_with_progress(const laboratory::CriticalPlan& plan) {
    StageProgress progress;
    return laboratory::test_to_critical_state(
        plan, [&](std::string_view stage, double fraction) { progress.update(stage, fraction); });
}

report::CriticalPicture picture_of(const std::vector<laboratory::CriticalTest>& tests) {
    report::CriticalPicture picture;
    for (const laboratory::CriticalTest& test : tests)
        picture.curves.push_back(
            {test.density, test.pressure, laboratory::critical_state(test).void_ratio(), test.rows});
    if (const auto line = laboratory::critical_line(tests)) picture.line = {line->e_0, line->slope};
    return picture;
}

void run(Options options) {
    const std::filesystem::path folder = options.folder;
    const io::FolderLock owner(folder);
    options.plan.pressures.clear();
    for (const double p : options.kilopascals) options.plan.pressures.push_back(1e3 * p);
    const std::vector<laboratory::CriticalTest> tests = test_with_progress(options.plan);
    io::write_text(folder / "critical_state.csv", laboratory::critical_csv(tests));
    io::write_text(folder / "curves.csv", laboratory::critical_curves_csv(tests));
    const auto picture = report::draw_critical_picture(picture_of(tests), folder / "critical_state.png");
    if (!picture.drawn) fmt::print(stderr, "{}\n", picture.message);
    fmt::print("{}{}: critical_state.csv, curves.csv, critical_state.png\n",
               laboratory::critical_table(tests, options.plan), options.folder);
}

}  // namespace

void add_rve_critical(CLI::App& rve) {
    CLI::App* critical = rve.add_subcommand(
        "critical", "critical state of Table 1 sand: shear at constant mean stress, dense and loose");
    auto options = std::make_shared<Options>();
    critical->add_option("-o,--out", options->folder, "folder for tables and picture")->capture_default_str();
    critical->add_option("--seeds", options->plan.seeds, "packings of each density")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    critical->add_option("--grains", options->plan.grains, "disks in a packing")
        ->check(CLI::Range(50, 10000))
        ->capture_default_str();
    critical->add_option("--pressures", options->kilopascals, "mean stresses held [kPa]")
        ->delimiter(',')
        ->check(CLI::Range(0.5, 1000.0))
        ->capture_default_str();
    critical->add_option("--strain", options->plan.strain, "shear strain at the end")
        ->check(CLI::Range(0.1, 100.0))
        ->capture_default_str();
    critical->add_option("--inertial-number", options->plan.inertial_number, "sets the shear rate")
        ->check(CLI::Range(1e-5, 0.1))
        ->capture_default_str();
    critical->callback([options] { run(*options); });
}

}  // namespace sandgraph::app
