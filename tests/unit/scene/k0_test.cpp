#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

std::string sand(const std::string& k0, const std::string& continuum = "") {
    return refused("[ground]\nlaw = \"mohr_coulomb\"\nk0 = " + k0 +
                   "\n[continuum]\nfriction_angle = \"30 deg\"\n" + continuum);
}

TEST(K0, OfMohrCoulombLiesBetweenActiveAndPassive) {
    EXPECT_EQ(sand("0.34"), "accepted");
    EXPECT_EQ(sand("2.99"), "accepted");
    EXPECT_EQ(
        sand("0.33"),
        "s.toml:3: ground.k0 = 0.33 (the ground would yield at rest: friction_angle = 30 deg holds 0.333 "
        "to 3.000); write a value between");
    EXPECT_EQ(sand("3.01").rfind("s.toml:3: ground.k0 = 3.01", 0), 0u);
}

// 2 c cos(phi) beside 2200 kg/m3 over 5 m, 108 kPa: 0.16.
TEST(K0, OfMohrCoulombIsWidenedByCohesion) {
    EXPECT_EQ(sand("0.23", "cohesion = \"10 kPa\"\n"), "accepted");
    EXPECT_NE(sand("0.22", "cohesion = \"10 kPa\"\n"), "accepted");
}

TEST(K0, OfElasticGroundIsAnyPositiveNumber) {
    EXPECT_EQ(refused("[ground]\nlaw = \"elastic\"\nk0 = 0.05\n"), "accepted");
    EXPECT_EQ(refused("[ground]\nk0 = 0\n"), "s.toml:2: ground.k0 = 0 (out of range); write a value > 0");
}

TEST(K0, OfAScreeningRunNeedsTheGate) {
    EXPECT_EQ(refused("mode = \"screening\"\n[ground]\nk0 = 0.5\n"), "accepted");
    const std::string error = refused("mode = \"screening\"\n[ground]\nk0 = 0.5\n[gate]\nactive = false\n");
    EXPECT_EQ(error.rfind("s.toml:3: ground.k0 = 0.5 (the surrogate alone", 0), 0u) << error;
    EXPECT_EQ(refused("mode = \"screening\"\n[gate]\nactive = false\n"), "accepted");
}

}  // namespace
}  // namespace sandgraph::scene
