#include <gtest/gtest.h>

#include "tests/unit/app/bad_input.hpp"

namespace sandgraph::app {
namespace {

// One wrong scene: what stands in it, the line that is to blame, and what the error must name.
struct Wrong {
    const char* name;
    const char* text;
    const char* where;
    const char* problem;
};

class BadScene : public testing::TestWithParam<Wrong> {};

TEST_P(BadScene, IsRefusedInOneLineAndNothingIsWritten) {
    const Wrong& wrong = GetParam();
    const Shell shell(wrong.name);
    shell.write("s.toml", wrong.text);
    expect_bad_input(shell.run("run s.toml -o out"), wrong.where, wrong.problem);
    EXPECT_EQ(shell.files(), 1);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadScene,
    testing::Values(
        Wrong{"unknown_key", "[anchor]\nembedement_ratio = 3\n", "s.toml:2",
              "did you mean \"embedment_ratio\"?"},
        Wrong{"unknown_table", "[anker]\nwidth = 3\n", "s.toml:1", "did you mean \"anchor\"?"},
        Wrong{"missing_unit", "\n[grains]\nfriction_angle = 35\n", "s.toml:3", "write \"35 deg\""},
        Wrong{"wrong_unit", "[anchor]\nwidth = \"1 kPa\"\n", "s.toml:2", "unit of pressure, not of length"},
        Wrong{"outside", "[anchor]\nembedment_ratio = 3\n[domain]\ndepth = \"2 m\"\n", "s.toml:4",
              "outside the ground"},
        Wrong{"negative_embedment", "[anchor]\nembedment_ratio = -3\n", "s.toml:2", "out of range"},
        Wrong{"not_toml", "[anchor\n", "s.toml:1", "not valid TOML"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(BadOverride, IsRefusedLikeTheScene) {
    const Shell shell("override");
    shell.write("s.toml", "");
    expect_bad_input(shell.run("run s.toml -o out --set anchor.width=1"), "--set", "write \"1 m\"");
    expect_bad_input(shell.run("run s.toml -o out --set anchor.wdith=1"), "--set", "did you mean \"width\"?");
    expect_bad_input(shell.run("run none.toml -o out"), "none.toml", "cannot be read");
    EXPECT_EQ(shell.files(), 1);
}

TEST(BadPacking, OfASceneIsRefusedBeforeAnythingIsWritten) {
    const Shell shell("scene_packing");
    shell.write("s.toml", "[grains]\npacking = \"p.csv\"\n");
    shell.write("p.csv", "# {}\n# cell\n# 0.1 0 0 0.1\nid,x,y,r\n0,0.05,0.05,0.01\n1,0.02,nan,0.01\n");
    expect_bad_input(shell.run("run s.toml -o out"), "p.csv:6", "not finite");
    EXPECT_EQ(shell.files(), 2);
}

}  // namespace
}  // namespace sandgraph::app
