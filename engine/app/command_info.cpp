#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "io/info.hpp"

namespace sandgraph::app {

void add_info_command(CLI::App& app, int&) {
    CLI::App* info = app.add_subcommand("info", "what is in a run, log, packing, model or checkpoint file");
    auto file = std::make_shared<std::string>();
    info->add_option("file", *file, "an HDF5 file")->required();
    info->callback([file] { fmt::print("{}", io::info(*file)); });
}

}  // namespace sandgraph::app
