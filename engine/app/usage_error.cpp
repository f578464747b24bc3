#include "app/usage_error.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/text.hpp"

namespace sandgraph::app {
namespace {

// The command the user got to.
const CLI::App& deepest(const CLI::App& app) {
    const CLI::App* at = &app;
    while (!at->get_subcommands().empty()) at = at->get_subcommands().back();
    return *at;
}

// "sandgraph rve test"
std::string full_name(const CLI::App& command) {
    if (!command.get_parent()) return command.get_name();
    return full_name(*command.get_parent()) + " " + command.get_name();
}

std::vector<std::string> names_of(const CLI::App& app, bool options) {
    std::vector<std::string> names;
    if (options)
        for (const CLI::Option* option : app.get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    else
        for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
            names.push_back(command->get_name());
    return names;
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    return std::string{trimmed(text)};
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App& command = deepest(app);
    const std::string name = full_name(command);
    const std::vector<std::string> extras = app.remaining(true);
    const std::string help = fmt::format("{} --help lists what there is", name);
    if (extras.empty()) return fmt::format("{}: {}; {}", name, one_line(error.what()), help);
    const bool is_option = extras.front().starts_with('-');
    const std::string advice = did_you_mean(extras.front(), names_of(command, is_option), help);
    return fmt::format("{}: unknown {} \"{}\"; {}", name, is_option ? "option" : "argument", extras.front(),
                       advice);
}

}  // namespace sandgraph::app
