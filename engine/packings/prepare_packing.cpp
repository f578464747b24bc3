#include "packings/prepare_packing.hpp"

#include <array>

#include "packings/load_packing.hpp"
#include "packings/make_assembly.hpp"
#include "packings/rve_options.hpp"

namespace sandgraph::packings {

dem::Recipe dem_recipe(const scene::Grains& grains) {
    dem::Recipe recipe;
    recipe.seed = grains.seed;
    recipe.grains = grains.count;
    recipe.r_min = grains.radius_min;
    recipe.r_max = grains.radius_max;
    recipe.pressure = grains.consolidation_pressure;
    recipe.porosity = grains.target_porosity;
    recipe.dt = preparation_time_step(grains.material, std::array{grains.radius_min, grains.radius_max});
    return recipe;
}

dem::AssemblyFactory fast_assemblies() {
    return [](const dem::Packing& packing, const dem::Material& material) {
        return make_assembly(scene::Kernel::fast, packing, material);
    };
}

dem::Packing base_packing(const scene::Grains& grains, const ProgressCallback& progress) {
    if (!grains.packing.empty()) return load_packing(grains.packing).packing;
    return dem::prepare(dem_recipe(grains), grains.material, fast_assemblies(), progress).packing;
}

}  // namespace sandgraph::packings
