#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/console.hpp"
#include "base/error.hpp"
#include "training/train_command.hpp"

// Started by `sandgraph train`, which makes the probe log and hands the other arguments on.
int main(int argc, char** argv) {
    using namespace sandgraph;
    CLI::App app{"Trains a surrogate from history logs.", "sandgraph-train"};
    training::TrainCommand command;
    app.add_option("recipe", command.recipe, "TOML file")->required();
    app.add_option("-o,--out", command.out, "model to write, HDF5");
    app.add_option("--probes", command.probes, "history log made for the recipe");
    app.add_option("--evaluate", command.evaluate, "model to measure instead of training one");
    app.add_flag("--ladder", command.ladder, "trains and measures every rung");
    app.add_flag("--measure", command.measure, "writes no model, its errors alone");
    CLI11_PARSE(app, argc, argv);
    try {
        return training::run(command);
    } catch (const InputError& error) {
        notice(error.what());
        return 2;
    } catch (const std::exception& error) {
        notice(fmt::format("sandgraph-train: {}", error.what()));
        return 1;
    }
}
