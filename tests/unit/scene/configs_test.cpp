#include <filesystem>

#include "scene/element_test_spec.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/train_spec.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

const std::string configs = std::string(SANDGRAPH_SOURCE) + "/configs/";

// Examples that nobody runs rot; the scenes are told from recipes and tests by their names.
TEST(Configs, AllAreValid) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(configs)) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".toml") continue;
        if (name.starts_with("rve_"))
            EXPECT_NO_THROW(read_recipe(entry.path().string())) << name;
        else if (name.starts_with("probe"))
            EXPECT_NO_THROW(read_probe(entry.path().string())) << name;
        else if (name.starts_with("train"))
            EXPECT_NO_THROW(read_train(entry.path().string())) << name;
        else if (name == "biaxial.toml" || name == "path.toml" || name == "simple_shear.toml")
            EXPECT_NO_THROW(read_element_test(entry.path().string())) << name;
        else
            EXPECT_NO_THROW(read_scene(entry.path().string())) << name;
    }
}

TEST(Configs, AnchorsHaveTheResolutionOfThePaper) {
    for (const char* name : {"anchor_horizontal.toml", "anchor_vertical.toml"}) {
        const Scene scene = read_scene(configs + name);
        const double points =
            scene.domain.width * scene.domain.depth / (scene.domain.cell * scene.domain.cell);
        EXPECT_EQ(scene.domain.cell, 0.1);
        EXPECT_EQ(scene.ground.grains.count, 400);
        EXPECT_GE(points, 7999);
        EXPECT_LE(points, 22400);
    }
}

}  // namespace
}  // namespace sandgraph::scene
