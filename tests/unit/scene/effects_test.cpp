#include "scene/effects.hpp"

#include <algorithm>
#include <filesystem>

#include "scene/element_test_keys.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/scene_keys.hpp"
#include "scene/train_spec.hpp"
#include "support/paths.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

const std::string kMohrCoulomb = "[ground]\nlaw = \"mohr_coulomb\"\n";

void expect_idle(const std::string& text, const std::string& where, const std::string& why,
                 const std::vector<std::string>& overrides = {}) {
    const std::string error = refused(text, overrides);
    EXPECT_EQ(error.rfind(where + ": ", 0), 0u) << error;
    EXPECT_NE(error.find(why), std::string::npos) << error;
    EXPECT_NE(error.find("; "), std::string::npos) << "no suggestion: " << error;
}

TEST(KeyWithoutEffect, OfAnotherLawIsRefused) {
    expect_idle("[continuum]\nfriction_angle = \"30 deg\"\n", "s.toml:2", "ground.law = \"rve\" by default");
    expect_idle(kMohrCoulomb + "[grains]\nfriction_angle = \"30 deg\"\n", "s.toml:4", "not grains");
    expect_idle(kMohrCoulomb + "[rve]\nsteps_min = 3\n", "s.toml:4", "not grains");
    expect_idle(kMohrCoulomb + "[gate]\nstrain = 0.01\n", "s.toml:4", "not grains");
    expect_idle("[ground]\nlaw = \"elastic\"\n[continuum]\nyoung = \"1 MPa\"\ncohesion = \"1 kPa\"\n",
                "s.toml:5", "never yields");
}

TEST(KeyWithoutEffect, IsRefusedOnTheCommandLineWhateverTheFileSays) {
    expect_idle("", "--set", "ground.law = \"rve\"", {"continuum.young=1 MPa"});
    expect_idle("", "--set", "ground.law = \"elastic\"", {"ground.law=elastic", "grains.seed=2"});
    expect_idle("[gate]\nstrain = 0.01\n", "--set", "mode = \"full\"", {"gate.strain=0.02"});
    expect_idle("", "--set", "mode = \"full\"", {"audit.share=0.1"});
    expect_idle("", "--set", "mode = \"full\"", {"mode=full", "surrogate.update_tolerance=0.1"});
}

// One scene serves several laws and modes.
TEST(KeyWithoutEffect, OfAFileMayStandWhereTheCommandLineSwitches) {
    const std::string grains = "[grains]\ndensity = \"loose\"\n[rve]\nsteps_min = 3\n";
    EXPECT_EQ(refused(grains, {"ground.law=mohr_coulomb", "continuum.young=1 MPa"}), "accepted");
    EXPECT_EQ(refused(kMohrCoulomb + "[continuum]\nyoung = \"1 MPa\"\n", {"ground.law=rve"}), "accepted");
    const std::string both =
        "[gate]\nstrain = 0.01\n[surrogate]\nupdate_tolerance = 0.1\n[audit]\nshare = 0.1\n";
    EXPECT_EQ(refused(both), "accepted");
    EXPECT_EQ(refused(both, {"mode=screening"}), "accepted");
    EXPECT_EQ(refused(both, {"mode=screening", "gate.active=false", "audit.share=0"}), "accepted");
    EXPECT_EQ(refused("[grains]\ndensity = \"custom\"\ntarget_porosity = 0.18\n", {"grains.density=loose"}),
              "accepted");
    EXPECT_EQ(parse_scene("[grains]\ndensity = \"custom\"\ntarget_porosity = 0.18\n", "s.toml",
                          std::vector<std::string>{"grains.density=loose"})
                  .ground.grains.target_porosity,
              0.20);
}

TEST(KeyWithoutEffect, BesideASwitchThatIsOffIsRefused) {
    expect_idle("[anchor]\npresent = false\nwidth = \"1 m\"\n", "s.toml:3", "anchor.present = false");
    expect_idle("[output]\nhistory_points = 10\n", "s.toml:2", "nothing is logged");
    expect_idle("[output]\nhistory_max = \"10 MB\"\n", "s.toml:2", "nothing is logged");
    expect_idle("[gate]\nactive = false\nstrain = 0.01\n", "s.toml:3", "gate.active = false");
    expect_idle("[gate]\nacoustic_from = 0.8\n", "s.toml:2", "is off");
    expect_idle("[audit]\nload_points = 0\nload_evenly = 0.5\n", "s.toml:3", "nothing is audited");
    EXPECT_EQ(refused("[audit]\nshare = 0\nseed = 3\n"), "accepted");  // the load is audited all the same
    expect_idle("[rve]\nupdate_tolerance = 0\nupdate_change_max = 0.1\n", "s.toml:3", "nothing is predicted");
    expect_idle("[rve]\nupdate_tolerance = 0\npredictor = \"elastic\"\n", "s.toml:3", "nothing is predicted");
    expect_idle("[rve]\nsteady_strain = 0.02\n", "s.toml:2", "never loosen");
    EXPECT_EQ(refused("[rve]\nsteady_factor = 2\nsteady_strain = 0.02\n"), "accepted");
    EXPECT_EQ(refused("[gate]\nactive = false\nblend_steps = 100\n"), "accepted");
}

TEST(KeyWithoutEffect, OfTheRecipeIsRefusedBesideAPacking) {
    const std::string packing =
        sandgraph::test::source_file("/CMakeLists.txt");  // any file: it is not read here
    for (const char* key : {"density = \"loose\"", "count = 400", "radius_min = \"3 mm\"",
                            "radius_max = \"7 mm\"", "seed = 1", "consolidation_pressure = \"10 kPa\""})
        expect_idle("[grains]\npacking = \"" + packing + "\"\n" + key + "\n", "s.toml:3", "made already");
    EXPECT_EQ(refused("[grains]\ndensity = \"loose\"\ncount = 400\n", {"grains.packing=" + packing}),
              "accepted");
}

// Else what a run keeps of itself could not be run again.
TEST(KeyWithoutEffect, IsNotInTheTextThatRunsKeep) {
    const Scene scene = parse_scene("[grains]\nseed = 3\n[gate]\nstrain = 0.01\n", "s.toml",
                                    std::vector<std::string>{"ground.law=mohr_coulomb"});
    EXPECT_EQ(scene.text.find("seed"), std::string::npos) << scene.text;
    EXPECT_NO_THROW(parse_scene(scene.text, "run")) << scene.text;
}

TEST(KeyWithoutEffect, OfARunThatIsOverIsRead) {
    EXPECT_NO_THROW(recorded_scene(kMohrCoulomb + "[grains]\nseed = 3\n", "run"));
}

TEST(ShippedScene, RunsUnderEveryLawAndInBothModes) {
    int scenes = 0;
    for (const char* folder : {"/configs", "/configs/paper"})
        for (const auto& entry : std::filesystem::directory_iterator(sandgraph::test::source_file(folder))) {
            if (entry.path().extension() != ".toml") continue;
            ++scenes;
            for (const char* set : {"ground.law=mohr_coulomb", "ground.law=elastic", "ground.law=rve",
                                    "mode=full", "mode=screening"})
                EXPECT_NO_THROW(read_scene(entry.path().string(), std::vector<std::string>{set}))
                    << entry.path() << ' ' << set;
        }
    EXPECT_GE(scenes, 6);
}

// A rule of a key that is called otherwise by now would never speak.
void expect_known(const KeyTable& keys, FileKind kind) {
    EXPECT_FALSE(effect_rules(kind).empty());
    for (const EffectRule& rule : effect_rules(kind)) {
        const auto named = [&rule](const Key& key) {
            return rule.keys == key.section || rule.keys == key.full_name();
        };
        EXPECT_TRUE(std::ranges::any_of(keys.keys(), named)) << rule.keys;
        if (*rule.decided_by) EXPECT_NO_THROW(keys.at(rule.decided_by)) << rule.decided_by;
    }
}

TEST(EffectRules, NameKeysThatExist) {
    Scene scene;
    expect_known(scene_keys(scene), FileKind::scene);
    RecipeSpec recipe;
    expect_known(recipe_keys(recipe), FileKind::recipe);
    ElementTestSpec test;
    expect_known(element_test_keys(test), FileKind::element_test);
    ProbeSpec probe;
    expect_known(probe_keys(probe), FileKind::probe);
    TrainSpec train;
    expect_known(train_keys(train), FileKind::train);
}

// Each rule speaks of its keys under some value of the key that decides.
TEST(EffectRules, OfChoicesHaveValuesThatExist) {
    Scene scene;
    const KeyTable keys = scene_keys(scene);
    for (const EffectRule& rule : effect_rules(FileKind::scene)) {
        const std::string allowed = keys.at(rule.decided_by).value->allowed(), values = rule.values;
        if (allowed.starts_with('"')) EXPECT_NE(allowed.find(values), std::string::npos) << rule.keys;
        if (allowed == "true or false") EXPECT_NE(allowed.find(values), std::string::npos) << rule.keys;
    }
}

TEST(Dilation, IsNotAboveFriction) {
    expect_idle(kMohrCoulomb + "[continuum]\ndilation_angle = \"35 deg\"\n", "s.toml:4", "give off energy");
    expect_idle(kMohrCoulomb + "[continuum]\nfriction_angle = \"20 deg\"\n", "--set",
                "write \"20 deg\" or less", {"continuum.dilation_angle=21 deg"});
    EXPECT_EQ(
        refused(kMohrCoulomb, {"continuum.friction_angle=32.8 deg", "continuum.dilation_angle=32.8 deg"}),
        "accepted");
}

TEST(UnitWeight, IsADensityAtStandardGravityOnly) {
    const std::string text = kMohrCoulomb + "[continuum]\ndensity = \"19.62 kN/m3\"\n";
    EXPECT_NEAR(parse_scene(text, "s.toml").ground.continuum.density, 2000, 1e-9);
    expect_idle(text, "s.toml:4", "gravity is another", {"ground.gravity=98.1 m/s2"});
}

}  // namespace
}  // namespace sandgraph::scene
