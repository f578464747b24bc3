#include <filesystem>

#include "scene/element_test_spec.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/sweep_rows.hpp"
#include "scene/train_spec.hpp"
#include "support/paths.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

const std::string configs = sandgraph::test::source_file("/configs/");

// Examples that nobody runs rot; what they are is told by their names. tests/examples runs them.
TEST(Configs, AllAreValid) {
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(configs)) {
        if (entry.path().extension() != ".toml") continue;
        const std::string file = entry.path().string(), name = entry.path().filename().string(),
                          folder = entry.path().parent_path().filename().string();
        if (name.starts_with("rve_"))
            EXPECT_NO_THROW(read_recipe(file)) << name;
        else if (name.starts_with("probe"))
            EXPECT_NO_THROW(read_probe(file)) << name;
        else if (name.starts_with("train"))
            EXPECT_NO_THROW(read_train(file)) << name;
        else if (folder == "sweeps")
            EXPECT_NO_THROW(read_sweep_table(file)) << name;
        else if (folder == "laboratory")
            EXPECT_NO_THROW(read_element_test(file)) << name;
        else
            EXPECT_NO_THROW(read_scene(file)) << name;
        ++files;
    }
    EXPECT_GE(files, 14);
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
