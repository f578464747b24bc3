#include "scene/recipe_spec.hpp"

#include "scene/effects.hpp"
#include "scene/file_kind.hpp"
#include "scene/grain_keys.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {

KeyTable recipe_keys(RecipeSpec& recipe) {
    KeyTable keys;
    keys.section("").real("pressure", recipe.pressure, "kPa", above(0), "isotropic, of the finished packing");
    add_grain_keys(keys, recipe.grains);
    return keys;
}

RecipeSpec read_recipe(const std::string& file) {
    RecipeSpec recipe;
    recipe.file = file;
    recipe.text = read_text(file);
    KeyTable keys = recipe_keys(recipe);
    const toml::table table = parse_toml(recipe.text, file);
    require_kind(table, file, FileKind::recipe);
    keys.read(table, file);
    check_effects(keys, FileKind::recipe);
    recipe.given = keys.given();
    complete_grains(keys, recipe.grains);
    check_pressure(keys.at("pressure"), recipe.pressure, recipe.grains);
    return recipe;
}

}  // namespace sandgraph::scene
