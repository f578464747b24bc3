#include "scene/foreign_words.hpp"

#include "scene/scene_keys.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

TEST(ForeignWord, IsSaidToBeUnsupportedInsteadOfTheNearestKey) {
    const std::pair<const char*, const char*> tried[] = {
        {"[ground]\nK0 = 0.5\n", "ground.k0"},
        {"[ground]\nwater_table = \"1 m\"\n", "the ground is dry"},
        {"[ground]\ncohesion = \"5 kPa\"\n", "continuum.cohesion"},
        {"[grains]\ncohesion = \"5 kPa\"\n", "do not stick together"},
        {"[grains]\npoisson = 0.3\n", "stiffness_ratio"},
        {"[ground]\nE50 = \"20 MPa\"\n", "continuum.young"},
        {"[domain]\nparticles_per_cell = 4\n", "domain.points_per_cell"},
        {"[mpm]\ndt = \"1e-4 s\"\n", "mpm.courant"},
        {"[anchor]\nload = \"10 kPa\"\n", "pulled at a given speed"},
        {"[anchor]\nroughness = 0.7\n", "anchor.friction_angle"},
        {"[water]\nlevel = 3\n", "the ground is dry"},
        {"[material]\nE = 3\n", "[continuum]"},
        {"threads = 4\n", "--threads N"}};
    for (const auto& [text, said] : tried) {
        const std::string error = refused(text);
        EXPECT_EQ(error.rfind("s.toml:", 0), 0u) << error;
        EXPECT_NE(error.find(said), std::string::npos) << error;
        EXPECT_EQ(error.find("did you mean"), std::string::npos) << error;
    }
}

TEST(ForeignWord, OfFrictionAsksWhoseItIs) {
    const std::string error = refused("[ground]\nfriction_angle = \"30 deg\"\n");
    EXPECT_NE(error.find("continuum.friction_angle"), std::string::npos) << error;
    EXPECT_NE(error.find("grains.friction_angle"), std::string::npos) << error;
}

// Else it would hide the better advice where the word really stands.
TEST(ForeignWord, IsNoKeyOfItsTable) {
    Scene scene;
    for (const Key& key : scene_keys(scene).keys())
        EXPECT_FALSE(foreign_word(key.section, key.name)) << key.full_name();
}

}  // namespace
}  // namespace sandgraph::scene
