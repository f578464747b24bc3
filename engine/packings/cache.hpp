#pragma once
#include <functional>
#include <string>

#include "io/packing_file.hpp"
#include "scene/scene.hpp"

namespace sandgraph::packings {

// A packing by what it is made from: taken from the cache folder ($SANDGRAPH_CACHE, else
// $XDG_CACHE_HOME/sandgraph, else ~/.cache/sandgraph) or made and kept there. `recipe` is the text that tells
// it from all others. A damaged or unwritable cache costs time, never the run.
dem::Packing cached_packing(const std::string& recipe, const dem::Material& material,
                            const std::function<dem::Packing()>& make);

// The same for `count` numbers.
std::vector<double> cached_numbers(const std::string& recipe, std::size_t count,
                                   const std::function<std::vector<double>()>& make);

// The text that tells the base packing of `grains` from all others; a packing file counts by its contents.
std::string packing_recipe(const scene::Grains& grains);

}  // namespace sandgraph::packings
