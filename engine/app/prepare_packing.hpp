#pragma once
#include "dem/prepare.hpp"
#include "dem/recipe.hpp"
#include "scene/scene.hpp"

namespace sandgraph::app {

dem::Recipe dem_recipe(const scene::Grains& grains);

// Packings are prepared with the optimised kernel.
dem::AssemblyFactory fast_assemblies();

// The base packing of `grains`: its packing file, or what its recipe makes; at rest.
dem::Packing base_packing(const scene::Grains& grains, const dem::Progress& progress = {});

}  // namespace sandgraph::app
