#include "scene/file_kind.hpp"

#include "scene/element_test_spec.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/sweep_keys.hpp"
#include "scene/train_spec.hpp"
#include "support/paths.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

template <class Read>
std::string complaint(Read read, const std::string& config) {
    try {
        read(sandgraph::test::source_file("/configs/" + config));
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(FileKind, IsToldByNameWhereAnotherIsWanted) {
    const auto scene = [](const std::string& file) { read_scene(file); };
    EXPECT_NE(complaint(scene, "laboratory/biaxial.toml").find("an element test, not a scene"),
              std::string::npos);
    EXPECT_NE(complaint(scene, "laboratory/path.toml").find("sandgraph rve test"), std::string::npos);
    EXPECT_NE(complaint(scene, "laboratory/rve_dense.toml").find("sandgraph rve prepare"), std::string::npos);
    EXPECT_NE(complaint(scene, "models/probe.toml").find("sandgraph rve probe"), std::string::npos);
    EXPECT_NE(complaint(scene, "models/train.toml").find("sandgraph train"), std::string::npos);
    EXPECT_NE(complaint(scene, "sweeps/anchor_table.toml").find("sandgraph sweep"), std::string::npos);
    EXPECT_NE(complaint(scene, "models/table1.surrogate.h5").find("it is an HDF5 file"), std::string::npos);
    const char* said = "this is a scene, not";
    EXPECT_NE(complaint([](const std::string& f) { read_element_test(f); }, "quick.toml").find(said),
              std::string::npos);
    EXPECT_NE(complaint(read_recipe, "quick.toml").find(said), std::string::npos);
    EXPECT_NE(complaint(read_probe, "quick.toml").find(said), std::string::npos);
    EXPECT_NE(complaint(read_sweep, "quick.toml").find(said), std::string::npos);
    EXPECT_NE(complaint(read_train, "quick.toml").find(said), std::string::npos);
}

TEST(FileKind, WithAStrayKeyOfAnotherIsStillItsOwn) {
    EXPECT_NE(refused("kind = \"biaxial\"\n[anchor]\nwidth = \"1 m\"\n").find("s.toml:1: unknown key kind"),
              std::string::npos);
}

}  // namespace
}  // namespace sandgraph::scene
