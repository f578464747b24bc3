#include "stability/run_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/hash.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"

namespace sandgraph::stability {
namespace {

namespace fs = std::filesystem;
namespace h5 = io::h5;
using Digest = std::map<std::string, std::string>;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return (std::ostringstream() << in.rdbuf()).str();
}

template <class T>
std::string bytes_of(const h5::Group& group, const std::string& name) {
    const std::vector<T> values = h5::read<T>(group, name);
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string content(const h5::Group& group, const std::string& name) {
    const std::string type = h5::type_name(group, name);
    if (type == "float64") return bytes_of<double>(group, name);
    if (type == "float32") return bytes_of<float>(group, name);
    if (type == "int64") return bytes_of<std::int64_t>(group, name);
    if (type == "int32") return bytes_of<std::int32_t>(group, name);
    if (type == "int16") return bytes_of<std::int16_t>(group, name);
    return bytes_of<std::uint8_t>(group, name);
}

void add(const h5::Group& group, const std::string& file, Digest& out) {
    for (const h5::Attribute& a : h5::attributes(group, "."))
        if (a.name != "threads")
            out[file + group.path() + "@" + a.name] =
                std::visit([](const auto& v) { return fmt::format("{}", v); }, a.value);
    for (const std::string& name : group.names()) {
        if (group.kind(name) == h5::Kind::group && name != "timing") add(group.open(name), file, out);
        if (group.kind(name) == h5::Kind::dataset)
            out[file + group.path_of(name)] = hex(hash64(content(group, name)));
    }
}

void add_summary(const fs::path& file, Digest& out) {
    const auto json = nlohmann::json::parse(text_of(file));
    for (const auto& [key, value] : json.items())
        if (key != "wall_s" && key != "cpu_s" && key != "threads" && !key.starts_with("seconds "))
            out["summary.json " + key] = value.dump();
}

}  // namespace

Digest digest(const fs::path& folder) {
    Digest out;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (!entry.is_regular_file()) continue;
        if (name == "summary.json")
            add_summary(entry.path(), out);
        else if (entry.path().extension() == ".h5")
            add(h5::File::open(entry.path()).root(), name, out);
        else
            out[name] = hex(hash64(text_of(entry.path())));
    }
    return out;
}

std::vector<std::string> differences(const Digest& a, const Digest& b) {
    std::vector<std::string> out;
    for (const auto& [name, value] : a)
        if (!b.contains(name) || b.at(name) != value) out.push_back(name);
    for (const auto& [name, value] : b)
        if (!a.contains(name)) out.push_back(name);
    return out;
}

void check_same(const std::string& what, const std::vector<std::string>& differences, Findings& found) {
    std::string text = "outputs that differ from those of " + what;
    for (std::size_t k = 0; k < std::min<std::size_t>(differences.size(), 3); ++k)
        text += "; " + differences[k];
    found.exactly(text, static_cast<double>(differences.size()), 0);
}

}  // namespace sandgraph::stability
