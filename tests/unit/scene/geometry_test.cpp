#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

void expect_refused(const std::string& text, const std::string& line, const std::string& why) {
    const std::string error = refused(text);
    EXPECT_EQ(error.rfind("s.toml:" + line + ": ", 0), 0u) << error;
    EXPECT_NE(error.find(why), std::string::npos) << error;
    EXPECT_NE(error.find("; "), std::string::npos) << "no suggestion: " << error;
}

TEST(Geometry, NegativeEmbedmentIsRefused) {
    expect_refused("[anchor]\nembedment_ratio = -1", "2", "out of range");
}

TEST(Geometry, PlateBelowTheBaseIsRefused) {
    expect_refused("[domain]\ndepth = \"2 m\"\n[anchor]\nembedment_ratio = 3", "2", "outside the ground");
}

TEST(Geometry, PlateBeyondTheSideIsRefused) {
    expect_refused("[domain]\nwidth = \"0.4 m\"", "2", "outside the ground");
    expect_refused("[domain]\nwidth = \"8 m\"\n[anchor]\norientation = \"vertical\"\nposition = \"9 m\"", "2",
                   "outside the ground");
}

TEST(Geometry, VerticalPlateAboveTheSurfaceIsRefused) {
    expect_refused("[anchor]\norientation = \"vertical\"\nembedment_ratio = 0.5", "3", "outside the ground");
}

TEST(Geometry, DomainTooSmallNamesTheSizeToWrite) {
    expect_refused("[domain]\ndepth = \"3.5 m\"", "2", "write \"4.1 m\" or more");
    EXPECT_EQ(refused("[domain]\ndepth = \"4.1 m\""), "accepted");
}

TEST(Geometry, LengthsAreWholeCells) { expect_refused("[domain]\ndepth = \"5.03 m\"", "2", "write \"5 m\""); }

TEST(Geometry, DefaultsThatDoNotFitAreNamed) {
    const std::string error = refused("[anchor]\nembedment_ratio = 30");
    EXPECT_EQ(error.rfind("s.toml: domain.depth = \"5 m\" (default)", 0), 0u) << error;
}

TEST(Geometry, PlateStaysInTheGroundWhilePulled) {
    expect_refused("[anchor]\nembedment_ratio = 1\npull_to = 1.5", "3", "would leave the ground");
    expect_refused("[domain]\nwidth = \"6 m\"\n[anchor]\norientation = \"vertical\"\npull_to = 3", "2",
                   "ahead of");
}

TEST(Geometry, VerticalPlateStandsInTheMiddleUnlessTold) {
    EXPECT_NEAR(parse_scene("[anchor]\norientation = \"vertical\"", "s.toml").anchor.position,
                Domain{}.width / 2, 0.5 * Domain{}.cell + 1e-12);
    EXPECT_EQ(
        parse_scene("[anchor]\norientation = \"vertical\"\nposition = \"2.05 m\"", "s.toml").anchor.position,
        2.05);
}

TEST(Geometry, PlateFacesLieBetweenThePoints) {
    expect_refused("[anchor]\nthickness = \"0.16 m\"", "2", "write \"0.2 m\"");
    expect_refused("[anchor]\nwidth = \"1.14 m\"", "2", "write \"1.1 m\"");
    expect_refused("[anchor]\nembedment_ratio = 2.33", "2", "write 2.3");
    expect_refused("[domain]\nwidth = \"8 m\"\n[anchor]\norientation = \"vertical\"\nposition = \"4 m\"", "5",
                   "between the points");
    EXPECT_EQ(refused("[domain]\npoints_per_cell = 4\n[anchor]\nthickness = \"0.15 m\""), "accepted");
}

TEST(Geometry, HorizontalPlateLiesOnTheSymmetryPlane) {
    expect_refused("[anchor]\nposition = \"1 m\"", "2", "symmetry plane");
}

TEST(Geometry, PlateNeedsGroundUnderStress) {
    const std::string weightless = "[ground]\ngravity = \"0 m/s2\"\n";
    expect_refused(weightless, "2", "nothing presses");
    EXPECT_EQ(refused(weightless + "surcharge = \"10 kPa\""), "accepted");
    EXPECT_EQ(refused(weightless + "[anchor]\npresent = false"), "accepted");
}

TEST(Geometry, IsNotAskedForWithoutAnAnchor) {
    EXPECT_EQ(refused("[domain]\nwidth = \"0.5 m\"\ndepth = \"1 m\"\n[anchor]\npresent = false"), "accepted");
}

TEST(Geometry, EndTimeIsForGroundWithoutAnAnchor) {
    const std::string ends = "[mpm]\nend_time = \"2 s\"\n";
    expect_refused(ends, "2", "ends with the pull");
    EXPECT_EQ(refused(ends + "[anchor]\npresent = false"), "accepted");
}

}  // namespace
}  // namespace sandgraph::scene
