#pragma once
#include <string>

#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// A packing recipe: [grains] as in a scene, and the pressure of the finished packing.
struct RecipeSpec {
    std::string file, text;
    Grains grains;
    double pressure = 10e3;  // [Pa]
    GivenKeys given;
};

// The keys of a recipe file, filling `recipe`, which must outlive the table.
KeyTable recipe_keys(RecipeSpec& recipe);

// Reads and checks a recipe. Throws InputError.
RecipeSpec read_recipe(const std::string& file);

}  // namespace sandgraph::scene
