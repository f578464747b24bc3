#pragma once
#include <filesystem>
#include <string>

namespace sandgraph::io {

// What is in an HDF5 file, as text for people: content and schema, then groups, datasets with type, shape and
// unit, and attributes; long texts are shortened. The checksum of a checkpoint or a
// surrogate model is verified. InputError when the file is missing, foreign or damaged.
std::string info(const std::filesystem::path& path);

}  // namespace sandgraph::io
