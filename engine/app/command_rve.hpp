#pragma once

namespace CLI {
class App;
}

namespace sandgraph::app {

// The commands under `rve`.
void add_rve_prepare(CLI::App& rve);
void add_rve_test(CLI::App& rve);
void add_rve_bench(CLI::App& rve);
void add_rve_study(CLI::App& rve);
void add_rve_table(CLI::App& rve);
void add_rve_critical(CLI::App& rve);
void add_rve_probe(CLI::App& rve);

}  // namespace sandgraph::app
