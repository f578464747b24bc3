#include "base/file_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "base/error.hpp"

namespace sandgraph {
namespace {

// Kinds of files that a name tells beyond doubt.
constexpr std::array<std::string_view, 19> known = {
    ".csv", ".h5",   ".hdf5", ".toml", ".json", ".png", ".svg", ".pdf", ".jpg", ".jpeg",
    ".gif", ".html", ".htm",  ".xdmf", ".xlsx", ".xls", ".ods", ".vtk", ".vtu"};

}  // namespace

std::string extension_of(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void require_extension(const std::string& file, const std::string& extension, Naming naming) {
    const std::string found = extension_of(file);
    const bool other = naming == Naming::always || std::ranges::find(known, found) != known.end();
    if (file.empty() || found == extension || !other) return;
    const std::string stem = file.substr(0, file.size() - found.size());
    throw InputError({file, 0}, fmt::format("not the name of a {} file", extension),
                     fmt::format("what is written here is {}", extension),
                     fmt::format("write {}{}", stem, extension));
}

}  // namespace sandgraph
