#include "scene/scene_hash.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

const std::string kPoint = "[[region]]\nname = \"P\"\nat = [\"1 m\", \"2 m\"]\npackings = [0, 0.1]\n";

TEST(Regions, AreRectanglesInPlateWidthsOrTrackedPointsInMetres) {
    const Scene scene =
        parse_scene("[[region]]\nname = \"A\"\nx = [-0.5, 0]\ny = [0, 1]\n" + kPoint, "s.toml", {});
    ASSERT_EQ(scene.regions.size(), 2u);
    EXPECT_FALSE(scene.regions[0].absolute);
    EXPECT_EQ(scene.regions[0].x, (std::array{-0.5, 0.0}));
    EXPECT_TRUE(scene.regions[1].tracked_point && scene.regions[1].absolute);
    EXPECT_EQ(scene.regions[1].y, (std::array{2.0, 2.0}));
    EXPECT_EQ(scene.regions[1].packings, (std::vector{0.0, 0.1}));
}

TEST(Regions, ChangeNoResultAndNoHash) {
    EXPECT_EQ(scene_hash(parse_scene(kPoint, "s.toml", {})), scene_hash(parse_scene("", "s.toml", {})));
}

// Before minutes of preparation, and a tracked point is not the nearest one of a place far away.
TEST(Regions, OutsideTheGroundAreRefusedAtTheirLine) {
    for (const char* place : {"at = [20, 0]", "at = [\"1 m\", \"-1 m\"]", "x = [7, 8]\ny = [0, 1]",
                              "x = [0, 1]\ny = [4, 5]", "x = [\"-3 m\", \"-1 m\"]\ny = [\"1 m\", \"2 m\"]"}) {
        const std::string error = refused("\n[[region]]\nname = \"A\"\n" + std::string(place));
        EXPECT_EQ(error.rfind("s.toml:2: [[region]] A lies outside the ground", 0), 0u) << error;
    }
    EXPECT_EQ(refused("[[region]]\nname = \"A\"\nx = [-0.5, 0.5]\ny = [0.1, 0.5]"), "accepted");
    EXPECT_EQ(
        refused("[anchor]\npresent = false\n[[region]]\nname = \"A\"\nat = [\"1 m\", \"9 m\"]").substr(0, 9),
        "s.toml:3:");
}

TEST(Regions, AreRefusedWithTheReason) {
    const auto refusal = [](const std::string& body) { return refused("[[region]]\n" + body); };
    EXPECT_NE(refusal("x = [0, 1]\ny = [0, 1]").find("s.toml:1: [[region]] name"), std::string::npos);
    EXPECT_NE(refusal("name = \"a/b\"\nat = [0, 0]").find("letters"), std::string::npos);
    EXPECT_NE(refusal("name = \"A\"\nx = [0, 1]").find("without a place"), std::string::npos);
    EXPECT_NE(refusal("name = \"A\"\nx = [1, 0]\ny = [0, 1]").find("without extent"), std::string::npos);
    EXPECT_NE(refusal("name = \"A\"\nx = [0, \"1 m\"]\ny = [0, 1]").find("two lengths"), std::string::npos);
    EXPECT_NE(refusal("name = \"A\"\nx = [0, 1]\nat = [0, 0]").find("no extent"), std::string::npos);
    EXPECT_NE(refusal("name = \"A\"\nwhere = 1").find("unknown key"), std::string::npos);
    EXPECT_NE(refused(kPoint + kPoint).find("two regions"), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::scene
