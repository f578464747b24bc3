#include "app/command_rve.hpp"

#include <CLI/CLI.hpp>

#include "app/commands.hpp"

namespace sandgraph::app {

void add_rve_command(CLI::App& app, int&) {
    CLI::App* rve = app.add_subcommand("rve", "one packing of grains by itself");
    rve->require_subcommand(1);
    add_rve_prepare(*rve);
    add_rve_test(*rve);
    add_rve_bench(*rve);
    add_rve_study(*rve);
    add_rve_table(*rve);
    add_rve_critical(*rve);
    add_rve_probe(*rve);
}

}  // namespace sandgraph::app
