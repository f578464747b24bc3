#include "packings/table1_packing.hpp"

#include "packings/packing_cache.hpp"
#include "packings/prepare_packing.hpp"

namespace sandgraph::packings {

dem::Packing table1_packing(const std::string& density, std::uint64_t seed, int count) {
    scene::Grains grains;
    grains.count = count;
    grains.seed = seed;
    grains.density = density;
    grains.target_porosity = density == "dense" ? 0.16 : 0.20;
    return cached_packing(packing_recipe(grains) + "base\n", grains.material,
                          [&] { return base_packing(grains); });
}

}  // namespace sandgraph::packings
