#include "scene/value.hpp"

#include <fmt/format.h>

#include <sstream>

namespace sandgraph::scene {

std::string Entry::text() const {
    if (const auto string = node.value_exact<std::string>()) return fmt::format("\"{}\"", *string);
    if (node.is_table()) return "a table";
    std::ostringstream out;
    node.visit([&](const auto& value) { out << value; });
    return out.str();
}

void Entry::refuse(const std::string& why, const std::string& suggestion) const {
    throw InputError(where, fmt::format("{} = {}", name, text()), why, suggestion);
}

}  // namespace sandgraph::scene
