#pragma once
#include <filesystem>

namespace sandgraph::io {

// Before minutes of work, not after: can `folder` be made and written to? InputError when not.
void require_writable(const std::filesystem::path& folder);

// The same for a file that is written at the end of the work; an empty name asks for nothing.
void require_writable_file(const std::filesystem::path& file);

}  // namespace sandgraph::io
