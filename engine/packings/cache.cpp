#include "packings/cache.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "dem/make_assembly.hpp"
#include "dem/prepare/prepare.hpp"
#include "io/atomic_file.hpp"

namespace sandgraph::packings {
namespace {

namespace fs = std::filesystem;

// Part of every name: raise it when preparation changes what it makes.
constexpr const char* kGeneration = "preparation 4";

// What the kernel of this program on this machine makes of a small gas under fast compression, bit for bit. A
// packing made with other rounding (another version, another instruction set) is another packing.
std::string kernel_fingerprint() {
    const dem::Material material;
    const auto sample = dem::fast_assemblies()(dem::random_gas({.count = 50}), material);
    sample->step(-20 * Mat2::Identity(), 1e-5, 2000);
    const Mat2 s = sample->stress();
    return fmt::format("{:a} {:a} {:a} {:a}", s(0, 0), s(0, 1), s(1, 0), s(1, 1));
}

std::string generation() {
    static const std::string text = fmt::format("{} {}\n", kGeneration, kernel_fingerprint());
    return text;
}

fs::path cache_folder() {
    const auto set = [](const char* name) { return std::getenv(name) && *std::getenv(name); };
    if (set("SANDGRAPH_CACHE")) return std::getenv("SANDGRAPH_CACHE");
    if (set("XDG_CACHE_HOME")) return fs::path(std::getenv("XDG_CACHE_HOME")) / "sandgraph";
    if (set("HOME")) return fs::path(std::getenv("HOME")) / ".cache" / "sandgraph";
    std::error_code none;
    const fs::path shared = fs::temp_directory_path(none);
    return none ? fs::path() : shared / "sandgraph-cache";
}

bool read_cached(const fs::path& file, const std::string& recipe, dem::Packing& packing) {
    std::error_code unreadable;  // a folder of somebody else, too long a name: nothing is cached there
    if (!fs::exists(file, unreadable)) return false;
    try {
        io::PackingRecord record = io::read_packing(file);
        if (record.recipe != recipe) return false;
        packing = std::move(record.packing);
        return true;
    } catch (const InputError&) {
        return false;  // damaged: made anew
    }
}

void keep(const fs::path& file, const std::function<void()>& write) {
    if (!file.has_parent_path()) return;  // no folder for a cache
    try {
        fs::create_directories(file.parent_path());
        write();
    } catch (const std::exception&) {
        // Without a writable cache the next run prepares again.
    }
}

}  // namespace

dem::Packing cached_packing(const std::string& recipe, const dem::Material& material,
                            const std::function<dem::Packing()>& make) {
    const std::string text = generation() + recipe;
    const fs::path file = cache_folder() / (hex(hash64(text)) + ".h5");
    dem::Packing packing;
    if (read_cached(file, text, packing)) return packing;
    packing = make();
    keep(file, [&] { io::write_packing(file, {packing, material, text}); });
    return packing;
}

std::vector<double> cached_numbers(const std::string& recipe, std::size_t count,
                                   const std::function<std::vector<double>()>& make) {
    const fs::path file = cache_folder() / (hex(hash64(generation() + recipe)) + ".txt");
    std::ifstream in(file);
    std::vector<double> values{std::istream_iterator<double>(in), {}};
    if (values.size() == count) return values;
    values = make();
    keep(file, [&] { io::write_text(file, fmt::format("{:.17g}\n", fmt::join(values, " "))); });
    return values;
}

std::string packing_recipe(const scene::Grains& g) {
    const dem::Material& m = g.material;
    std::string text = fmt::format("material {:a} {:a} {:a} {:a} {:a} {:a} {:a} {:a} {}\n", m.density,
                                   m.young, m.stiffness_ratio, m.friction_angle, m.rolling_stiffness,
                                   m.rolling_limit, m.damping, m.depth, static_cast<int>(m.rolling_form));
    if (g.packing.empty())
        return text + fmt::format("recipe {} {:a} {:a} {:a} {:a} {}\n", g.count, g.radius_min, g.radius_max,
                                  g.target_porosity, g.consolidation_pressure, g.seed);
    std::ifstream in(g.packing, std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    return text + fmt::format("file {}\n", hex(hash64(content.str())));
}

}  // namespace sandgraph::packings
