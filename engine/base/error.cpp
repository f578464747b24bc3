#include "base/error.hpp"

#include <fmt/format.h>

namespace sandgraph {
namespace {

std::string one_line(const InputError::Where& where, const std::string& problem, const std::string& why,
                     const std::string& suggestion) {
    std::string text = where.line > 0 ? fmt::format("{}:{}: {}", where.file, where.line, problem)
                                      : fmt::format("{}: {}", where.file, problem);
    if (!why.empty()) text += fmt::format(" ({})", why);
    if (!suggestion.empty()) text += fmt::format("; {}", suggestion);
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

}  // namespace

InputError::InputError(const Where& where, const std::string& problem, const std::string& why,
                       const std::string& suggestion)
    : std::runtime_error(one_line(where, problem, why, suggestion)) {}

}  // namespace sandgraph
