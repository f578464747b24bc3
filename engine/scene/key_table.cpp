#include "scene/key_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"
#include "scene/foreign_words.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

InputError::Where where_of(const toml::node& node, const std::string& file) {
    // The command line has no lines.
    return {file, file == override_file ? 0 : static_cast<int>(node.source().begin.line)};
}

}  // namespace

Key& KeyTable::Section::add(const char* name, std::unique_ptr<Value> value, const char* meaning) {
    table_.keys_.push_back({.section = name_, .name = name, .meaning = meaning, .value = std::move(value)});
    return table_.keys_.back();
}

Key& KeyTable::Section::real(const char* name, double& value, const char* unit, Range range,
                             const char* meaning) {
    return add(name, std::make_unique<Real>(value, unit, range), meaning);
}

Key& KeyTable::Section::flag(const char* name, bool& value, const char* meaning) {
    return add(name, std::make_unique<Flag>(value), meaning);
}

Key& KeyTable::Section::text(const char* name, std::string& value, const char* meaning) {
    return add(name, std::make_unique<Text>(value), meaning);
}

Key& KeyTable::Section::input_file(const char* name, std::string& value, const char* meaning) {
    return add(name, std::make_unique<InputFile>(value), meaning);
}

const Key& KeyTable::at(std::string_view full_name) const {
    const auto found = std::ranges::find(keys_, full_name, &Key::full_name);
    if (found == keys_.end()) throw std::logic_error(fmt::format("no key {}", full_name));
    return *found;
}

GivenKeys KeyTable::given() const {
    GivenKeys out;
    for (const Key& key : keys_)
        if (key.given) out[key.full_name()] = key.where;
    return out;
}

std::vector<std::string> KeyTable::section_names() const {
    std::vector<std::string> names;
    for (const Key& key : keys_)
        if (!key.section.empty() && std::ranges::find(names, key.section) == names.end())
            names.push_back(key.section);
    return names;
}

void KeyTable::read(const toml::table& root, const std::string& file, NamedFiles files) {
    files_ = files;
    const std::vector<std::string> sections = section_names();
    for (const auto& [key, node] : root) {
        const std::string name{key.str()};
        const bool is_section = std::ranges::find(sections, name) != sections.end();
        if (is_section && node.is_table())
            read_section(*node.as_table(), name, file);
        else if (is_section)
            Entry{node, where_of(node, file), name}.refuse("not a table", fmt::format("write [{}]", name));
        else
            read_key(node, "", name, file);
    }
}

void KeyTable::read_section(const toml::table& table, const std::string& section, const std::string& file) {
    for (const auto& [key, node] : table) read_key(node, section, std::string{key.str()}, file);
}

void KeyTable::read_key(const toml::node& node, const std::string& section, const std::string& name,
                        const std::string& file) {
    const Entry entry{node, where_of(node, file), section.empty() ? name : section + "." + name, files_};
    const auto key = std::ranges::find_if(
        keys_, [&](const Key& known) { return known.section == section && known.name == name; });
    if (key == keys_.end()) refuse_key(entry, section, name);
    key->value->read(entry);
    key->where = entry.where;
    key->given = true;
}

// Best advice first: what this table's users mean by the word, the same key of another table, what anybody
// means by it, the nearest name at this level.
void KeyTable::refuse_key(const Entry& entry, const std::string& section, const std::string& name) const {
    const bool is_table = entry.node.is_table();
    const std::string problem = fmt::format("unknown {} {}", is_table ? "table" : "key", entry.name);
    const std::string known = "sandgraph keys lists what is known";
    if (const auto word = foreign_word(section, name))
        throw InputError(entry.where, problem, word->why, word->advice);
    const auto elsewhere = std::ranges::find(keys_, name, &Key::name);
    if (elsewhere != keys_.end() && !is_table)
        throw InputError(
            entry.where, problem, known,
            fmt::format("it belongs to {}",
                        elsewhere->section.empty() ? "the top of the file" : "[" + elsewhere->section + "]"));
    if (const auto word = foreign_word(any_table, name))
        throw InputError(entry.where, problem, word->why, word->advice);
    std::vector<std::string> names = section.empty() ? section_names() : std::vector<std::string>{};
    for (const Key& key : keys_)
        if (key.section == section) names.push_back(key.name);
    throw InputError(entry.where, problem, known, did_you_mean(name, names, "take one of those"));
}

}  // namespace sandgraph::scene
