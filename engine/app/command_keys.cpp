#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "scene/element_test_keys.hpp"
#include "scene/key_help.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/scene_keys.hpp"
#include "scene/train_spec.hpp"

namespace sandgraph::app {
namespace {

std::string test_help(scene::TestKind kind) {
    scene::ElementTestSpec spec;
    spec.kind = kind;
    return scene::key_help(scene::element_test_keys(spec));
}

std::string help_of(const std::string& what) {
    if (what == "path") return test_help(scene::TestKind::path);
    if (what == "biaxial") return test_help(scene::TestKind::biaxial);
    if (what == "isotropic") return test_help(scene::TestKind::isotropic);
    scene::ProbeSpec probe;
    if (what == "probe") return scene::key_help(scene::probe_keys(probe));
    scene::TrainSpec train;
    if (what == "train") return scene::key_help(scene::train_keys(train));
    scene::RecipeSpec recipe;
    if (what == "recipe") return scene::key_help(scene::recipe_keys(recipe));
    scene::Scene scene;
    return scene::key_help(scene::scene_keys(scene));
}

}  // namespace

void add_keys_command(CLI::App& app, int&) {
    CLI::App* keys =
        app.add_subcommand("keys", "lists every key of an input file with default, unit and range");
    auto what = std::make_shared<std::string>("scene");
    keys->add_option("file", *what, "scene, recipe, probe, train, path, biaxial or isotropic")
        ->check(CLI::IsMember({"scene", "recipe", "probe", "train", "path", "biaxial", "isotropic"}));
    keys->callback([what] { fmt::print("{}", help_of(*what)); });
}

}  // namespace sandgraph::app
