#include "packings/base_packing.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file_name.hpp"
#include "dem/make_assembly.hpp"
#include "dem/packing/csv.hpp"
#include "dem/prepare/prepare.hpp"
#include "packings/cache.hpp"
#include "scene/grain_keys.hpp"

namespace sandgraph::packings {

namespace {

io::PackingRecord read_any(const std::string& file) {
    const std::string kind = extension_of(file);
    if (kind == ".csv") return {.packing = dem::read_packing_csv(file), .material = {}, .recipe = {}};
    if (kind == ".h5") return io::read_packing(file);
    throw InputError({file, 0}, "unknown kind of packing file", "its name must tell the format",
                     "give a .csv or .h5 file");
}

}  // namespace

io::PackingRecord load_packing(const std::string& file) {
    io::PackingRecord record = read_any(file);
    const std::size_t grains = record.packing.size();
    if (grains < dem::fewest_grains)
        throw InputError({file, 0}, fmt::format("{} grain{}", grains, grains == 1 ? "" : "s"),
                         fmt::format("fewer than {} are no sample of sand", dem::fewest_grains),
                         "give a packing of some hundred");
    return record;
}

bool has_material(const std::string& file) { return extension_of(file) == ".h5"; }

dem::Packing base_packing(const scene::Grains& grains, const ProgressCallback& progress) {
    if (!grains.packing.empty()) return load_packing(grains.packing).packing;
    return dem::prepare(grains, grains.material, dem::fast_assemblies(), progress).packing;
}

dem::Packing table1_packing(const std::string& density, std::uint64_t seed, int count) {
    scene::Grains grains;
    grains.count = count;
    grains.seed = seed;
    grains.density = density;
    grains.target_porosity = scene::porosity_of(density);
    return cached_packing(packing_recipe(grains) + "base\n", grains.material,
                          [&] { return base_packing(grains); });
}

}  // namespace sandgraph::packings
