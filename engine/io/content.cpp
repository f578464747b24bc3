#include "io/content.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "io/h5_attribute.hpp"

namespace sandgraph::io {
namespace {

// The user block as it must be for the bytes behind it.
std::string expected_seal(std::istream& file) {
    file.seekg(seal_size);
    Hasher hasher;
    std::uint64_t length = 0;
    std::vector<char> buffer(1 << 16);
    while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), file.gcount() > 0) {
        const auto count = static_cast<std::size_t>(file.gcount());
        hasher.add(std::as_bytes(std::span(buffer.data(), count)));
        length += count;
    }
    std::string block = fmt::format("sandgraph seal 1\nlength {}\nhash {}\n", length, hex(hasher.value()));
    block.resize(seal_size, '\0');
    return block;
}

}  // namespace

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

void seal(const std::filesystem::path& path) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    const std::string block = expected_seal(file);
    file.clear();
    file.seekp(0);
    file.write(block.data(), seal_size);
    file.flush();
    if (!file) throw std::runtime_error(path.string() + ": cannot write the checksum");
}

std::optional<std::string> broken_seal(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return "cannot be read";
    std::string found(seal_size, '\0');
    file.read(found.data(), seal_size);
    if (!file) return "truncated: shorter than its header";
    if (!found.starts_with("sandgraph seal 1\n")) return "its header is damaged or of another program";
    if (found != expected_seal(file)) return "truncated or damaged: length or checksum differ";
    return std::nullopt;
}

}  // namespace sandgraph::io
