#include "support/paths.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

Grains grains(const std::string& text) { return parse_scene(text, "s.toml").ground.grains; }

TEST(Density, NamesStandForPorosity) {
    EXPECT_EQ(grains("[grains]\ndensity = \"dense\"").target_porosity, 0.16);
    EXPECT_EQ(grains("[grains]\ndensity = \"loose\"").target_porosity, 0.20);
}

TEST(Density, CustomTakesTheKeys) {
    const Grains g = grains("[grains]\ndensity = \"custom\"\ntarget_porosity = 0.18");
    EXPECT_EQ(g.target_porosity, 0.18);
}

TEST(Density, ContradictionIsRefused) {
    EXPECT_EQ(refused("[grains]\ndensity = \"loose\"\ntarget_porosity = 0.16"),
              "s.toml:3: grains.target_porosity = 0.16 (density = \"loose\" sets it); write density = "
              "\"custom\" or "
              "leave this key out");
}

TEST(Grains, SmallestIsNotAboveLargest) {
    EXPECT_EQ(refused("[grains]\nradius_min = \"9 mm\"").rfind("s.toml:2: grains.radius_min = \"9 mm\"", 0),
              0u);
}

TEST(Grains, SamplesAreOfARecipeNotOfAPackingFile) {
    EXPECT_EQ(grains("").samples, 1);
    EXPECT_EQ(grains("[grains]\nsamples = 4").samples, 4);
    EXPECT_EQ(refused("[grains]\nsamples = 0"), "s.toml:2: grains.samples = 0 (out of range); write >= 1");
    const std::string file = test::source_file("/tests/data/yade/packing_dense_p10.csv");
    const std::string error = refused("[grains]\nsamples = 4\npacking = \"" + file + "\"");
    EXPECT_EQ(error.rfind("s.toml:2: grains.samples = 4 (", 0), 0u) << error;
    EXPECT_NE(error.find("is one packing"), std::string::npos) << error;
    EXPECT_EQ(refused("[grains]\nsamples = 1\npacking = \"" + file + "\""), "accepted");
}

TEST(Grains, PackingFileMustExist) {
    EXPECT_EQ(refused("[grains]\npacking = \"none.csv\"").rfind("s.toml:2: grains.packing", 0), 0u);
}

}  // namespace
}  // namespace sandgraph::scene
