#include "scene/toml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "base/error.hpp"
#include "base/text.hpp"

namespace sandgraph::scene {
namespace {

[[noreturn]] void refuse_assignment(const std::string& assignment) {
    throw InputError({override_file, 0}, fmt::format("\"{}\"", assignment), "not an assignment",
                     "write --set section.key=value");
}

// `name = value` in line `line`, the value TOML or plain text; none for a name that is none.
std::optional<toml::table> assigned(const std::string& name, const std::string& value, int line) {
    const std::string before(static_cast<std::size_t>(std::max(line - 1, 0)), '\n');
    for (const std::string& written : {value, fmt::format("'''{}'''", value)}) try {
            return toml::parse(before + fmt::format("{} = {}", name, written));
        } catch (const toml::parse_error&) {
        }
    return std::nullopt;
}

}  // namespace

std::string read_text(const std::string& file) {
    if (std::filesystem::is_directory(file))
        throw InputError({file, 0}, "cannot be read", "it is a folder", "give the name of a file");
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (in) text << in.rdbuf();
    if (!in)
        throw InputError({file, 0}, "cannot be read", "no such file, or no permission", "check the path");
    return text.str();
}

toml::table parse_toml(const std::string& text, const std::string& file) {
    constexpr std::string_view signature = "\x89HDF\r\n";  // behind a seal in models and checkpoints
    if (std::string_view(text).substr(0, 4096).find(signature) != std::string_view::npos)
        throw InputError({file, 0}, "not valid TOML", "it is an HDF5 file: a packing, run, log or model",
                         "`sandgraph info` tells what is in it; give a TOML file here");
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError({file, static_cast<int>(error.source().begin.line)}, "not valid TOML",
                         std::string{error.description()}, "mend the line; texts need quotes, numbers none");
    }
}

toml::table parse_value(const std::string& name, const std::string& value, const InputError::Where& where) {
    if (auto table = assigned(name, value, where.line)) return *std::move(table);
    throw InputError(where, fmt::format("{} = {}", name, value), "not a key and its value",
                     "write the key as section.name");
}

toml::table parse_override(const std::string& assignment) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos) refuse_assignment(assignment);
    const std::string name{trimmed(assignment.substr(0, equals))};
    const std::string value{trimmed(assignment.substr(equals + 1))};
    if (auto table = assigned(name, value, 1)) return *std::move(table);
    refuse_assignment(assignment);
}

void merge(toml::table& base, const toml::table& extra) {
    for (const auto& [key, node] : extra) {
        toml::table* old = base[key].as_table();
        if (old && node.is_table())
            merge(*old, *node.as_table());
        else
            node.visit([&, name = key.str()](const auto& value) { base.insert_or_assign(name, value); });
    }
}

}  // namespace sandgraph::scene
