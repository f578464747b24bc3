#pragma once
#include <memory>

namespace CLI {
class App;
}
namespace sandgraph::simulation {
class Crew;
}

namespace sandgraph::app {

// Each command registers itself and, when it runs, writes its exit code. Errors leave as exceptions.
void add_rve_command(CLI::App& app, int& exit_code);
void add_train_command(CLI::App& app, int& exit_code);
void add_report_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_keys_command(CLI::App& app, int& exit_code);
void add_run_command(CLI::App& app, int& exit_code, std::shared_ptr<simulation::Crew> crew);
void add_compare_command(CLI::App& app, int& exit_code);
void add_pareto_command(CLI::App& app, int& exit_code);
void add_sweep_command(CLI::App& app, int& exit_code);
void add_budget_command(CLI::App& app, int& exit_code);
void add_measure_command(CLI::App& app, int& exit_code);

}  // namespace sandgraph::app
