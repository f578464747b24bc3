#include <filesystem>
#include <fstream>
#include <numbers>

#include "scene/key_help.hpp"
#include "scene/scene_keys.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

TEST(SceneKeys, AreReadInSiUnits) {
    const Scene scene = parse_scene(R"(
title = "a"
[domain]
width = "300 cm"
[anchor]
embedment_ratio = 2.5
friction_angle = "30 deg"
[ground]
surcharge = "12 kPa"
[grains]
radius_min = "2 mm"
[output]
frames = [0, 0.1]
)",
                                    "s.toml");
    EXPECT_EQ(scene.domain.width, 3);
    EXPECT_EQ(scene.anchor.embedment_ratio, 2.5);
    EXPECT_EQ(scene.anchor.friction_angle, 30 * std::numbers::pi / 180);
    EXPECT_EQ(scene.ground.surcharge, 12e3);
    EXPECT_EQ(scene.ground.grains.radius_min, 0.002);
    EXPECT_EQ(scene.output.frames, (std::vector<double>{0, 0.1}));
}

TEST(SceneKeys, AnEmptySceneIsTheDefault) {
    const Scene scene = parse_scene("", "s.toml");
    EXPECT_EQ(scene.domain.depth, Domain{}.depth);
    EXPECT_EQ(scene.ground.grains.material.friction_angle, dem::Material{}.friction_angle);
}

TEST(SceneKeys, OfVisitsAreRead) {
    const graph::RveSettings usual = parse_scene("", "s.toml").ground.rve,
                             rve = parse_scene(
                                       "[rve]\npredictor = \"elastic\"\nrate_jump_max = 2\n"
                                       "steady_factor = 3\nsteady_strain = 0.02\nsteps_max = 40\n",
                                       "s.toml")
                                       .ground.rve;
    EXPECT_EQ(usual.predictor, graph::Predictor::secant);
    EXPECT_EQ(usual.steps_max, 0);
    EXPECT_EQ(rve.predictor, graph::Predictor::elastic);
    EXPECT_EQ(rve.rate_jump_max, 2);
    EXPECT_EQ(rve.steady_factor, 3);
    EXPECT_EQ(rve.steady_strain, 0.02);
    EXPECT_EQ(rve.steps_max, 40);
    EXPECT_NE(refused("[rve]\nsteady_factor = 0.5").find("rve.steady_factor"), std::string::npos);
    EXPECT_NE(refused("[rve]\npredictor = \"secand\"").find("did you mean"), std::string::npos);
}

TEST(SceneKeys, UnknownOnesAreRefusedWithTheNearest) {
    EXPECT_EQ(
        refused("[domain]\nwidht = \"3 m\""),
        "s.toml:2: unknown key domain.widht (sandgraph keys lists what is known); did you mean \"width\"?");
    EXPECT_NE(refused("[anchr]\nwidth = \"3 m\"").find("did you mean \"anchor\"?"), std::string::npos);
    EXPECT_NE(refused("tilte = \"x\"").find("did you mean \"title\"?"), std::string::npos);
}

TEST(SceneKeys, OfAnotherTableAreSentThere) {
    EXPECT_NE(refused("[anchor]\ncell = \"0.1 m\"").find("it belongs to [domain]"), std::string::npos);
}

TEST(SceneKeys, WithoutTheirUnitAreRefused) {
    EXPECT_EQ(refused("\n\n[anchor]\nfriction_angle = 35"),
              "s.toml:4: anchor.friction_angle = 35 (no unit); write \"35 deg\"");
}

TEST(SceneKeys, WithAWrongUnitAreRefused) {
    EXPECT_EQ(refused("[domain]\ncell = \"0.1 kPa\""),
              "s.toml:2: domain.cell = \"0.1 kPa\" (\"kPa\" is a unit of pressure, not of length); write "
              "\"0.1 m\"");
}

TEST(SceneKeys, OfTheWrongTypeAreRefused) {
    for (const char* text :
         {"[output]\npictures = 1", "[domain]\npoints_per_cell = 1.5", "[anchor]\npull_to = \"0.1\"",
          "[output]\nframes = 0.1", "[output]\nframes = [0.2, 0.1]", "domain = 3", "title = 3",
          "[grains]\nseed = -1", "[anchor]\npull_to = nan", "[domain]\npoints_per_cell = 2"})
        EXPECT_EQ(refused(text).rfind("s.toml:", 0), 0u) << text << " -> " << refused(text);
}

TEST(SceneKeys, ChoicesNameTheNearest) {
    EXPECT_EQ(refused("[ground]\nlaw = \"mohr-coulomb\""),
              "s.toml:2: ground.law = \"mohr-coulomb\" (known: rve, elastic, mohr_coulomb); did you mean "
              "\"mohr_coulomb\"?");
}

TEST(SceneKeys, SyntaxErrorsKeepTheirLine) {
    EXPECT_EQ(refused("[domain]\nwidth = = 3").rfind("s.toml:2: ", 0), 0u);
}

TEST(SceneKeys, HelpNamesEveryKeyAndReadsBackAsDefaults) {
    Scene scene;
    const KeyTable keys = scene_keys(scene);
    const std::string help = key_help(keys, FileKind::scene);
    EXPECT_NE(help.find("embedment_ratio = 3"), std::string::npos);
    EXPECT_NE(help.find("pull_rate = \"0.05 m/s\""), std::string::npos);
    std::string text = help;
    for (const char* file : {"packing = ", "model = "})  // the default, no file, cannot be given
        text.insert(text.find(file), "# ");
    EXPECT_NE(help.find("\n# target_porosity = "), std::string::npos);  // belongs to density = "custom"
    EXPECT_EQ(parse_scene(text, "s.toml").anchor.pull_rate, Anchor{}.pull_rate);
}

TEST(SceneFile, ThatIsMissingIsBadInput) { EXPECT_THROW(read_scene("no_such_folder/none.toml"), InputError); }

// Whoever reads a run that is over need not have what it was made from.
TEST(RecordedScene, NamesFilesThatMayBeGone) {
    const std::string text = "[grains]\npacking = \"gone.h5\"\n";
    EXPECT_THROW(parse_scene(text, "s.toml"), InputError);
    EXPECT_EQ(recorded_scene(text, "run").ground.grains.packing, "gone.h5");
    EXPECT_THROW(recorded_scene("[grains]\npacking = 3\n", "run"), InputError);
}

}  // namespace
}  // namespace sandgraph::scene
