#include "scene/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "base/text.hpp"

namespace sandgraph::scene {
namespace {

std::string word(const Entry& entry) {
    const auto text = entry.node.value_exact<std::string>();
    if (!text) entry.refuse("not a text", "write it in quotes");
    return *text;
}

}  // namespace

void Flag::read(const Entry& entry) {
    const auto value = entry.node.value_exact<bool>();
    if (!value) entry.refuse("neither true nor false", "write true or false, without quotes");
    value_ = *value;
}

void Text::read(const Entry& entry) { value_ = word(entry); }

void InputFile::read(const Entry& entry) {
    namespace fs = std::filesystem;
    const fs::path name = word(entry), beside = fs::path(entry.where.file).parent_path() / name;
    // Without the code a name too long would throw (found by fuzzing).
    std::error_code none;
    if (entry.files == NamedFiles::exist && (fs::is_directory(beside, none) || fs::is_directory(name, none)))
        entry.refuse("it is a folder", "name a file in it");
    const bool found = fs::is_regular_file(beside, none) || fs::is_regular_file(name, none);
    if (!found && entry.files == NamedFiles::exist)
        entry.refuse("no such file", "give a path relative to the file that names it, or an absolute one");
    value_ = (fs::is_regular_file(beside, none) ? beside : name).string();
}

void Choice::read(const Entry& entry) {
    const std::string name = word(entry);
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end())
        entry.refuse(fmt::format("known: {}", fmt::join(names_, ", ")),
                     did_you_mean(name, names_, "write one of them"));
    set_(static_cast<std::size_t>(found - names_.begin()));
}

std::string Choice::allowed() const { return fmt::format("\"{}\"", fmt::join(names_, "\", \"")); }

}  // namespace sandgraph::scene
