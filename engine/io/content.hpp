#pragma once
#include <cstdint>
#include <string>

#include "io/h5_group.hpp"

namespace sandgraph::io {

// Every file says what it is: root attributes `content` ("run", "packing", "checkpoint", ...) and `schema`.
void mark_content(h5::Group& root, const std::string& content, std::int64_t schema);

// InputError when the file holds something else or a schema this version cannot read.
void require_content(const h5::Group& root, const std::string& content, std::int64_t schema);

}  // namespace sandgraph::io
