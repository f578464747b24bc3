#pragma once
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace sandgraph::app {

// What is wrong with the arguments, in one line, with the nearest option or command that exists.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace sandgraph::app
