#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/usage_error.hpp"
#include "base/console.hpp"
#include "base/error.hpp"
#include "base/revision.hpp"

namespace sandgraph::app {
namespace {

void add_commands(CLI::App& app, int& exit_code, const std::shared_ptr<simulation::Crew>& crew) {
    app.set_version_flag("--version", fmt::format("sandgraph {}", revision()));
    app.require_subcommand(1);
    add_run_command(app, exit_code, crew);
    add_sweep_command(app, exit_code);
    add_budget_command(app, exit_code);
    add_compare_command(app, exit_code);
    add_pareto_command(app, exit_code);
    add_rve_command(app, exit_code);
    add_train_command(app, exit_code);
    add_report_command(app, exit_code);
    add_measure_command(app, exit_code);
    add_info_command(app, exit_code);
    add_keys_command(app, exit_code);
}

int report_error(const std::string& line, ExitCode code) {
    notice(line);
    return code;
}

}  // namespace

int run_command_line(int argc, const char* const* argv, std::shared_ptr<simulation::Crew> crew) {
    CLI::App app{"How plate anchors break out of sand: MPM for the ground, a DEM packing at every point.",
                 "sandgraph"};
    int exit_code = exit_done;
    add_commands(app, exit_code, crew);
    try {
        app.parse(argc, argv);
        return exit_code;
    } catch (const CLI::ParseError& error) {
        const bool wanted = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);  // --help
        return wanted ? app.exit(error) : report_error(usage_error(app, error), exit_bad_input);
    } catch (const InputError& error) {
        return report_error(error.what(), exit_bad_input);
    } catch (const std::exception& error) {
        return report_error(fmt::format("sandgraph: {}", error.what()), exit_failed);
    }
}

}  // namespace sandgraph::app
