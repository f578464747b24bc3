#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "io/h5_group.hpp"

namespace sandgraph::io {

// Every file says what it is: root attributes `content` ("run", "packing", "checkpoint", ...) and `schema`.
void mark_content(h5::Group& root, const std::string& content, std::int64_t schema);

// InputError when the file holds something else or a schema this version cannot read.
void require_content(const h5::Group& root, const std::string& content, std::int64_t schema);

// A checkpoint's HDF5 user block holds the length and a 64-bit hash of all bytes behind it, so that damage to
// data *and* metadata shows before HDF5 parses a byte (its own checksums cover only chunked data).
inline constexpr unsigned seal_size = 512;

void seal(const std::filesystem::path& path);

// Why the file is not as it was sealed; empty when it is.
std::optional<std::string> broken_seal(const std::filesystem::path& path);

}  // namespace sandgraph::io
