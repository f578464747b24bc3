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

TEST(Units, OfSoilMechanicsAreKnown) {
    EXPECT_EQ(si("30 kN/m2", "kPa"), 30e3);
    EXPECT_EQ(si("30 kN/m^2", "kPa"), 30e3);
    EXPECT_EQ(si("30 kN/m\u00B2", "kPa"), 30e3);
    EXPECT_EQ(si("0.3 bar", "kPa"), 0.3e5);
    EXPECT_EQ(si("20 N/mm2", "MPa"), 20e6);
    EXPECT_EQ(si("20 MN/m2", "MPa"), 20e6);
    EXPECT_EQ(si("2.65 g/cm3", "kg/m3"), 2650);
    EXPECT_EQ(si("2.65 t/m3", "kg/m3"), 2650);
    EXPECT_EQ(si("2.65 Mg/m3", "kg/m3"), 2650);
    EXPECT_EQ(si("3 mm/min", "m/s"), 3.0 / 60e3);
    EXPECT_EQ(si("3 mm / min", "m/s"), 3.0 / 60e3);
    EXPECT_EQ(si("3 cm/s", "m/s"), 0.03);
    EXPECT_EQ(si("6 %/min", "1/s"), 0.001);
    EXPECT_EQ(si("30\u00B0", "deg"), si("30 deg", "deg"));
    EXPECT_EQ(si("1 m/s^2", "m/s2"), 1);
}

TEST(Units, OfWeightAreDensitiesAtStandardGravity) {
    EXPECT_NEAR(si("19.62 kN/m3", "kg/m3"), 2000, 1e-9);
    EXPECT_NEAR(si("19.62 kPa/m", "kg/m3"), 2000, 1e-9);
    EXPECT_TRUE(is_unit_weight("19.62 kN/m^3"));
    EXPECT_FALSE(is_unit_weight("2000 kg/m3"));
    EXPECT_NE(error("16 kN/m3", "kPa").find("unit of unit weight, not of pressure"), std::string::npos);
    EXPECT_NE(error("16 kN/m", "kPa").find("unit of force a length"), std::string::npos);
}

TEST(Units, ThatAreNoneOfSiAreRefusedInWords) {
    for (const auto& [text, like] : {std::pair{"3 ft", "m"},
                                     {"3 in", "m"},
                                     {"5 psi", "kPa"},
                                     {"2 ksf", "kPa"},
                                     {"100 pcf", "kg/m3"},
                                     {"1 ft/s", "m/s"},
                                     {"2 kgf/cm2", "kPa"},
                                     {"1 atm", "kPa"}}) {
        EXPECT_NE(error(text, like).find("is no SI unit"), std::string::npos) << error(text, like);
        EXPECT_NE(error(text, like).find(std::string("write it in ") + like), std::string::npos);
        EXPECT_EQ(error(text, like).find("did you mean"), std::string::npos) << error(text, like);
    }
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
    EXPECT_EQ(si("35 degrees", "deg"), si("35 deg", "deg"));
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
