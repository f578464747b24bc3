#include <gtest/gtest.h>

#include "scene/read_scene.hpp"
#include "simulation/build_screening.hpp"
#include "support/paths.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::simulation {
namespace {

namespace fs = std::filesystem;
using test::Scratch;

constexpr const char* kName = "table1.surrogate.h5";

// An empty file of that name in `folder` of a checkout.
fs::path put(const Scratch& checkout, const std::string& folder) {
    fs::create_directories(checkout / folder);
    test::overwrite(checkout / folder / kName, "");
    return (checkout / folder / kName).lexically_normal();
}

fs::path found(const Scratch& checkout, std::vector<std::string> set = {}) {
    const std::string scene = (checkout / "study/deep/scene.toml").string();
    set.emplace_back("mode=screening");
    return model_file(scene::parse_scene("", scene, set)).lexically_normal();
}

TEST(ModelFile, IsTheNearestAboveTheScene) {
    const Scratch checkout;
    for (const char* nearer : {"configs", "configs/models", "models", "study/configs/models", "study/deep"}) {
        const fs::path file = put(checkout, nearer);
        EXPECT_EQ(found(checkout), file) << nearer;
    }
}

TEST(ModelFile, IsTheScenesOwnIfItNamesOne) {
    const Scratch checkout;
    put(checkout, "configs/models");
    const fs::path own = put(checkout, "mine");
    EXPECT_EQ(found(checkout, {"surrogate.model=" + own.string()}), own);
}

// A scene far from any checkout: the model that came with the program.
TEST(ModelFile, IsElseTheOneOfTheProgram) {
    const Scratch elsewhere;
    const fs::path file = found(elsewhere);
    EXPECT_EQ(file.filename(), kName);
    EXPECT_EQ(fs::canonical(file),
              fs::canonical(sandgraph::test::source_file("/configs/models/table1.surrogate.h5")));
}

}  // namespace
}  // namespace sandgraph::simulation
