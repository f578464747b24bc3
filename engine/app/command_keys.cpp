#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands.hpp"
#include "scene/element_test_keys.hpp"
#include "scene/key_help.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/scene_keys.hpp"
#include "scene/sweep_keys.hpp"
#include "scene/train_spec.hpp"

namespace sandgraph::app {
namespace {

std::string test_help(scene::TestKind kind) {
    scene::ElementTestSpec spec;
    spec.kind = kind;
    return scene::key_help(scene::element_test_keys(spec), scene::FileKind::element_test);
}

std::string help_of(const std::string& what) {
    const std::vector<std::string> tests = scene::test_kind_names();
    if (const auto test = std::ranges::find(tests, what); test != tests.end())
        return test_help(static_cast<scene::TestKind>(test - tests.begin()));
    scene::ProbeSpec probe;
    if (what == "probe") return scene::key_help(scene::probe_keys(probe), scene::FileKind::probe);
    scene::TrainSpec train;
    if (what == "train") return scene::key_help(scene::train_keys(train), scene::FileKind::train);
    scene::RecipeSpec recipe;
    if (what == "recipe") return scene::key_help(scene::recipe_keys(recipe), scene::FileKind::recipe);
    scene::SweepSpec sweep;
    if (what == "sweep") return scene::key_help(scene::sweep_keys(sweep), scene::FileKind::sweep);
    scene::Scene scene;
    return scene::key_help(scene::scene_keys(scene), scene::FileKind::scene);
}

}  // namespace

void add_keys_command(CLI::App& app, int&) {
    CLI::App* keys =
        app.add_subcommand("keys", "lists every key of an input file with default, unit and range");
    auto what = std::make_shared<std::string>("scene");
    std::vector<std::string> files = scene::test_kind_names();
    files.insert(files.begin(), {"scene", "recipe", "probe", "train", "sweep"});
    keys->add_option("file", *what, "scene, recipe, probe, train, sweep, or the kind of an element test")
        ->check(CLI::IsMember(files));
    keys->callback([what] { fmt::print("{}", help_of(*what)); });
}

}  // namespace sandgraph::app
