#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/failure_table.hpp"
#include "app/writable.hpp"
#include "io/atomic_file.hpp"

namespace sandgraph::app {
namespace {

struct Arguments {
    std::vector<std::string> folders;
    std::string csv;
};

void run(const Arguments& a) {
    require_writable_file(a.csv);
    const std::string table = failure_csv(a.folders);
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
    command->add_option("--csv", a->csv, "file instead of the screen");
    command->callback([a, &exit_code] {
        run(*a);
        exit_code = exit_done;
    });
}

}  // namespace sandgraph::app
