#include "base/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace sandgraph {
namespace {

double si(const char* text, const char* like) {
    return parse_quantity({"scene.toml", 14}, "key", text, like);
}

std::string error(const char* text, const char* like) {
    try {
        si(text, like);
    } catch (const InputError& e) {
        return e.what();
    }
    return "accepted";
}

TEST(Units, ConvertToSiWithTheBitsOfTheLiteral) {
    EXPECT_EQ(si("30 kPa", "Pa"), 30e3);
    EXPECT_EQ(si("800 MPa", "Pa"), 800e6);
    EXPECT_EQ(si("7 mm", "m"), 0.007);
    EXPECT_EQ(si("23 deg", "rad"), 23.0 * std::numbers::pi / 180.0);
    EXPECT_EQ(si("0.05 m/s", "m/s"), 0.05);
    EXPECT_EQ(si("0.1 1/s", "1/s"), 0.1);
    EXPECT_EQ(si("2650 kg/m3", "kg/m3"), 2650);
    EXPECT_EQ(si("1e-5 s", "s"), 1e-5);
    EXPECT_EQ(si("9.81 m/s2", "m/s2"), 9.81);
}

TEST(Units, AllowBlanksAndSigns) {
    EXPECT_EQ(si("  +5mm ", "m"), 0.005);
    EXPECT_EQ(si("-3 kPa", "Pa"), -3e3);
}

TEST(Units, AskForAMissingUnit) {
    EXPECT_EQ(error("35", "deg"), "scene.toml:14: key = \"35\" (no unit); write \"35 deg\"");
}

TEST(Units, RefuseAnotherDimension) {
    EXPECT_EQ(
        error("35 kPa", "deg"),
        "scene.toml:14: key = \"35 kPa\" (\"kPa\" is a unit of pressure, not of angle); write \"35 deg\"");
}

TEST(Units, SuggestTheNearestKnownUnit) {
    EXPECT_EQ(error("35 kpa", "Pa"),
              "scene.toml:14: key = \"35 kpa\" (unknown unit \"kpa\"); did you mean \"kPa\"?");
    EXPECT_EQ(error("35 degrees", "deg"),
              "scene.toml:14: key = \"35 degrees\" (unknown unit \"degrees\"); did you mean \"deg\"?");
}

TEST(Units, RefuseWhatIsNoFiniteNumber) {
    EXPECT_NE(error("nan kPa", "Pa").find("not a finite number"), std::string::npos);
    EXPECT_NE(error("inf kPa", "Pa").find("not a finite number"), std::string::npos);
    EXPECT_NE(error("kPa", "Pa").find("does not start with a number"), std::string::npos);
    EXPECT_NE(error("", "Pa").find("does not start with a number"), std::string::npos);
    EXPECT_NE(error("1e999 kPa", "Pa").find("scene.toml:14"), std::string::npos);
}

TEST(Units, AreWrittenAsPeopleWriteThem) {
    EXPECT_EQ(format_quantity(30e3, "kPa"), "30 kPa");
    EXPECT_EQ(format_quantity(23 * std::numbers::pi / 180, "deg"), "23 deg");
    EXPECT_EQ(format_quantity(0.25, ""), "0.25");
}

TEST(Units, RoundTrip) {
    for (const double value : {1.0 / 3, 12345.678, 1e-5})
        EXPECT_NEAR(si(format_quantity(value, "kPa").c_str(), "Pa"), value, 1e-11 * value);
}

}  // namespace
}  // namespace sandgraph
