#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "base/file_name.hpp"
#include "io/atomic_file.hpp"
#include "results/failure_table.hpp"

namespace sandgraph::app {
namespace {

constexpr const char* kColumns =
    R"(Columns: lengths in plate widths B, angles in degrees to the horizontal, nan where there is none.
highest_rise, lowest_rise: of the surface, share of the pull. visible_ahead, heave_ahead, sink_behind: how
far the surface has moved, from the plate's start. zone_*: points strained past 0.1, from the plate's centre.
cavity: open share of the plate's track. band_rotation: of points strained past 0.2.
band_*, recent_* (all strain; since the frame before): the shear band in the lower, middle and upper third
above a horizontal plate, x/B where it meets the surface, its outer edge there (strain 0.2; faint: 0.1), its
dilation angle. slip_*: on the upright surface through the plate's edge K, the mean tan(delta), the same with
each row's largest of all frames, and the shares of the surface before and past that.)";

struct Arguments {
    std::vector<std::string> folders;
    std::string csv;
};

void run(const Arguments& a) {
    require_extension(a.csv, ".csv"), io::require_writable_file(a.csv);
    const std::string table = results::failure_csv(a.folders);
    if (a.csv.empty())
        fmt::print("{}", table);
    else
        io::write_text(a.csv, table);
}

}  // namespace

void add_measure_command(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand(
        "measure",
        "how far the failure of finished runs reaches and how its shear band lies, frame by frame");
    command->add_option("folders", a->folders, "run folders, or folders of them")->required();
    command->footer(kColumns);
    command->add_option("--csv", a->csv, "file instead of the screen");
    command->callback([a, &exit_code] {
        run(*a);
        exit_code = exit_done;
    });
}

}  // namespace sandgraph::app
