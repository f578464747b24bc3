#pragma once
#include "dem/prepare/prepare.hpp"
#include "scene/scene.hpp"

namespace sandgraph::packings {

dem::Recipe dem_recipe(const scene::Grains& grains);

// Packings are prepared with the optimised kernel.
dem::AssemblyFactory fast_assemblies();

// The base packing of `grains`: its packing file, or what its recipe makes; at rest.
dem::Packing base_packing(const scene::Grains& grains, const ProgressCallback& progress = {});

}  // namespace sandgraph::packings
