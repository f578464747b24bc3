#include <gtest/gtest.h>

#include "scene/read_scene.hpp"
#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

const std::string kGround = "[ground]\nlaw = \"mohr_coulomb\"\n";

std::string body(const std::string& keys) { return kGround + "[[body]]\n" + keys; }

void expect_refused(const std::string& text, const std::string& why) {
    const std::string error = refused(text);
    EXPECT_NE(error.find(why), std::string::npos) << error;
    EXPECT_EQ(error.rfind("s.toml:", 0), 0u) << error;
}

TEST(Bodies, StandInsteadOfAnAnchorThatTheSceneDoesNotHave) {
    const Scene s = parse_scene(body("centre = [\"0 m\", \"5.2 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"
                                     "velocity = [\"0 m/s\", \"-0.01 m/s\"]\ntravel = \"0.05 m\"\n"),
                                "s.toml");
    EXPECT_FALSE(s.anchor.present);
    ASSERT_TRUE(s.loaded_body());
    EXPECT_EQ(s.loaded_body()->width(), 1);
    EXPECT_NEAR(s.anchor.pull_to, 0.05, 1e-15);
    EXPECT_EQ(s.anchor.pull_rate, 0.01);
}

TEST(Bodies, ThatOverlapOrLeaveTheGroundAreRefused) {
    const std::string a = "centre = [\"2 m\", \"3 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n";
    expect_refused(body(a) + "[[body]]\ncentre = [\"2.4 m\", \"3.2 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n",
                   "overlaps the body");
    expect_refused(body("centre = [\"5.8 m\", \"3 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"), "right side");
    expect_refused(body("centre = [\"0.3 m\", \"3 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"), "left side");
    expect_refused(body("centre = [\"0 m\", \"5.2 m\"]\nsize = [\"14 m\", \"0.4 m\"]\n"), "right side");
    expect_refused(body("centre = [\"2 m\", \"0.1 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"), "base");
    expect_refused(body("centre = [\"2 m\", \"3.03 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"),
                   "between the points");
    expect_refused(body("centre = [\"2 m\", \"3 m\"]\nsize = [\"1.03 m\", \"0.4 m\"]\n"),
                   "between the points");
    const std::string thin = "centre = [\"2 m\", \"3.05 m\"]\nsize = [\"1 m\", \"0.1 m\"]\n";
    expect_refused(body(thin) + "[[body]]\ncentre = [\"2 m\", \"3.35 m\"]\nsize = [\"1 m\", \"0.1 m\"]\n",
                   "thinner than two cells");
    expect_refused(body("shape = \"circle\"\ncentre = [\"2 m\", \"3 m\"]\nradius = \"0.1 m\"\n"),
                   "no circle");
}

TEST(Bodies, SayWhatIsMissing) {
    expect_refused(body("size = [\"1 m\", \"0.4 m\"]\n"), "where it is");
    expect_refused(body("centre = [\"2 m\", \"3 m\"]\n"), "how large");
    expect_refused(body("shape = \"circle\"\ncentre = [\"2 m\", \"3 m\"]\n"), "how large");
    expect_refused(body("centre = [\"2 m\", \"3 m\"]\nsize = [\"1 m\", \"0.4 m\"]\nangle = \"30 deg\"\n"),
                   "along x and y");
    expect_refused(body("centre = [\"2 m\", \"3 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"
                        "velocity = [\"0 m/s\", \"1 cm/s\"]\n"),
                   "when it stops");
    expect_refused(body("centre = [2, 3]\nsize = [\"1 m\", \"0.4 m\"]\n"), "quantities as text");
}

}  // namespace
}  // namespace sandgraph::scene
