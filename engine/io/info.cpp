#include "io/info.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/content.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "io/history.hpp"
#include "io/history_file.hpp"

namespace sandgraph::io {
namespace {

constexpr std::size_t longest_text = 60;

std::string quoted(const std::string& text) {
    const std::size_t line = text.find('\n');
    if (line == std::string::npos && text.size() <= longest_text) return fmt::format("\"{}\"", text);
    return fmt::format("\"{}...\" ({} characters)", text.substr(0, std::min(line, longest_text)),
                       text.size());
}

std::string shown(const h5::Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
    return fmt::format("{}", std::get<double>(value));
}

std::string dataset_line(const h5::Group& group, const std::string& name, const std::string& indent) {
    std::string shape;
    for (const std::size_t n : h5::shape(group, name))
        shape += fmt::format("{}{}", shape.empty() ? "" : " x ", n);
    std::string line = fmt::format("{}{:<18} {} ({})", indent, name, h5::type_name(group, name), shape);
    if (h5::has_attribute(group, name, "unit"))
        line += fmt::format(" [{}]", h5::get_text(group, name, "unit"));
    for (const char* names : {"components", "values"})
        if (h5::has_attribute(group, name, names))
            line += fmt::format(" ({})", h5::get_text(group, name, names));
    return line + "\n";
}

// A group may hold itself, many times over.
constexpr std::size_t deepest = 32;  // spaces
constexpr std::size_t most_objects = 100'000;

std::string tree(const h5::Group& group, const std::string& indent, std::size_t& objects) {
    std::string text;
    if (indent.size() > deepest) return indent + "...\n";
    for (const h5::Attribute& a : h5::attributes(group, "."))
        text += fmt::format("{}{} = {}\n", indent, a.name, shown(a.value));
    for (const std::string& name : group.names()) {
        if (++objects > most_objects) return text + indent + "...\n";
        const h5::Kind kind = group.kind(name);
        if (kind == h5::Kind::dataset) text += dataset_line(group, name, indent);
        if (kind == h5::Kind::group)
            text += fmt::format("{}{}/\n", indent, name) + tree(group.open(name), indent + "  ", objects);
    }
    return text;
}

}  // namespace

std::string info(const std::filesystem::path& path) {
    const h5::File file = h5::File::open(path);
    const h5::Group root = file.root();
    std::string text = path.string() + "\n";
    const std::string content =
        h5::has_attribute(root, ".", "content") ? h5::get_text(root, ".", "content") : "";
    if (content == "history") text += history_overview(read_history(path));
    if (content == "checkpoint" || content == "surrogate") {
        if (const auto problem = broken_seal(path))
            throw InputError(
                {path.string()}, fmt::format("the {} is damaged", content), *problem,
                content == "surrogate" ? "copy or train it again" : "use the one before it, *.prev");
        text += "  checksum verified\n";
    }
    std::size_t objects = 0;
    return text + tree(root, "  ", objects);
}

}  // namespace sandgraph::io
