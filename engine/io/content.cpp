#include "io/content.hpp"

#include <fmt/format.h>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "io/h5_attribute.hpp"

namespace sandgraph::io {

void mark_content(h5::Group& root, const std::string& content, std::int64_t schema) {
    SG_EXPECT(!content.empty() && schema >= 1);
    h5::set_attribute(root, ".", "content", content);
    h5::set_attribute(root, ".", "schema", schema);
}

void require_content(const h5::Group& root, const std::string& content, std::int64_t schema) {
    if (!h5::has_attribute(root, ".", "content"))
        throw InputError({root.file()}, "not written by sandgraph", "the attribute 'content' is missing",
                         fmt::format("give a {} file", content));
    const std::string found = h5::get_text(root, ".", "content");
    if (found != content)
        throw InputError({root.file()}, fmt::format("this is a {} file", found),
                         fmt::format("a {} is expected here", content), "check the path");
    const std::int64_t version = h5::get_integer(root, ".", "schema");
    if (version != schema)
        throw InputError({root.file()}, fmt::format("{} schema {}", content, version),
                         fmt::format("this version reads schema {}", schema),
                         "write the file again with this version of sandgraph");
}

}  // namespace sandgraph::io
