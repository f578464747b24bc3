#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands.hpp"
#include "scene/element_test_keys.hpp"
#include "scene/key_help.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/scene_keys.hpp"
#include "scene/train_spec.hpp"

namespace sandgraph::app {
namespace {

// As the table and the rules of a kind of file have it.
template <class Spec, class MakeKeys>
std::string help(Spec&& spec, MakeKeys make_keys) {
    const scene::KeyTable keys = make_keys(spec);
    return scene::key_help(keys, scene::effect_rules(spec, keys));
}

std::string test_help(scene::TestKind kind) {
    scene::ElementTestSpec spec;
    spec.kind = kind;
    return help(spec, scene::element_test_keys);
}

std::string help_of(const std::string& what) {
    const std::vector<std::string> tests = scene::test_kind_names();
    if (const auto test = std::ranges::find(tests, what); test != tests.end())
        return test_help(static_cast<scene::TestKind>(test - tests.begin()));
    if (what == "probe") return help(scene::ProbeSpec(), scene::probe_keys);
    if (what == "train") return help(scene::TrainSpec(), scene::train_keys);
    if (what == "recipe") return help(scene::RecipeSpec(), scene::recipe_keys);
    return help(scene::Scene(), scene::scene_keys);
}

}  // namespace

void add_keys_command(CLI::App& app, int&) {
    CLI::App* keys =
        app.add_subcommand("keys", "lists every key of an input file with default, unit and range");
    auto what = std::make_shared<std::string>("scene");
    std::vector<std::string> files = scene::test_kind_names();
    files.insert(files.begin(), {"scene", "recipe", "probe", "train"});
    keys->add_option("file", *what, "scene, recipe, probe, train, or the kind of an element test")
        ->check(CLI::IsMember(files));
    keys->callback([what] { fmt::print("{}", help_of(*what)); });
}

}  // namespace sandgraph::app
