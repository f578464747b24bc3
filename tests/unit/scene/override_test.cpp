#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

Scene with(const std::vector<std::string>& overrides) {
    return parse_scene("[domain]\nwidth = \"4 m\"\n", "s.toml", overrides);
}

TEST(Override, NeedsNoInnerQuotes) {
    EXPECT_EQ(with({"domain.width=5 m"}).domain.width, 5);
    EXPECT_EQ(with({"domain.width=\"5 m\""}).domain.width, 5);
    EXPECT_EQ(with({"anchor.orientation = vertical", "domain.width=9 m"}).anchor.orientation,
              Orientation::vertical);
    EXPECT_EQ(with({"mode=screening"}).mode, Mode::screening);
    EXPECT_TRUE(with({"output.pictures=true"}).output.pictures);
    EXPECT_EQ(with({"output.frames=[0, 0.3]"}).output.frames.size(), 2u);
}

TEST(Override, LaterOnesWin) { EXPECT_EQ(with({"domain.width=5 m", "domain.width=6 m"}).domain.width, 6); }

TEST(Override, PassesTheSameChecks) {
    EXPECT_EQ(refused("", {"domain.cell=3"}).rfind("--set: ", 0), 0u);
    EXPECT_NE(refused("", {"domain.cell=3"}).find("domain.cell = 3 (no unit); write \"3 m\""),
              std::string::npos);
    EXPECT_NE(refused("", {"domain.sell=3 m"}).find("did you mean \"cell\"?"), std::string::npos);
    EXPECT_NE(refused("", {"domain.cell"}).find("write --set section.key=value"), std::string::npos);
    EXPECT_EQ(refused("", {"anchor.embedment_ratio=-2"}).rfind("--set: ", 0), 0u);
}

// For checks that come later: each key is refused where it was given.
TEST(Override, IsTheLastPlaceWhereAKeyWasGiven) {
    const Scene scene = with({"anchor.pull_rate=1 m/s"});
    EXPECT_EQ(scene.where("anchor.pull_rate").file, "--set");
    EXPECT_EQ(scene.where("domain.width").file, "s.toml");
    EXPECT_EQ(scene.where("domain.width").line, 2);
    EXPECT_EQ(scene.where("domain.cell").file, "s.toml");
    EXPECT_EQ(scene.where("domain.cell").line, 0);
}

TEST(Override, StandsInTheTextThatRunsKeep) {
    const Scene scene = with({"domain.width=5 m", "anchor.embedment_ratio=2"});
    const Scene again = parse_scene(scene.text, "s.toml");
    EXPECT_EQ(again.domain.width, 5);
    EXPECT_EQ(again.anchor.embedment_ratio, 2);
}

TEST(Override, AbsentLeavesTheTextAsItIs) { EXPECT_EQ(with({}).text, "[domain]\nwidth = \"4 m\"\n"); }

}  // namespace
}  // namespace sandgraph::scene
