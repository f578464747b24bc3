#include "scene/key_help.hpp"

#include <fmt/format.h>

namespace sandgraph::scene {

std::string key_help(const KeyTable& table, FileKind kind) {
    std::string text, section;
    for (const Key& key : table.keys()) {
        if (key.section != section) text += fmt::format("\n[{}]\n", section = key.section);
        const std::string shown = key.value->shown(), allowed = key.value->allowed();
        const char* mark = is_idle(table, key, kind) ? "# " : "";
        text += fmt::format("{:<44} # {}{}\n", fmt::format("{}{} = {}", mark, key.name, shown), key.meaning,
                            allowed.empty() ? "" : " (" + allowed + ")");
    }
    return text;
}

}  // namespace sandgraph::scene
