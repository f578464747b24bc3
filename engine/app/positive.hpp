#pragma once
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

namespace sandgraph::app {

// An option's value must be a finite number above 0.
inline CLI::Validator positive() {
    return CLI::Validator(
        [](std::string& text) {
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            const bool good = end != text.c_str() && *end == '\0' && std::isfinite(value) && value > 0;
            return good ? std::string{} : "\"" + text + "\" is not a number above 0";
        },
        "NUMBER");
}

}  // namespace sandgraph::app
