#include "results/mesh_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/read_scene.hpp"
#include "tests/support/sand_scene.hpp"

namespace sandgraph::results {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

scene::Scene plate(const std::vector<std::string>& set) {
    return scene::parse_scene(support::sand_scene({.cell = 0.1, .thickness = 0.1}), "s.toml", set);
}

double error(const std::vector<std::string>& set, double degrees = 30) {
    return book_mesh_error(plate(set), degrees * kDegree);
}

TEST(MeshError, FallsWithTheCell) {
    const double ten = error({}, 20), twenty = error({"domain.cell=0.05 m"}, 20),
                 five = error({"domain.cell=0.2 m", "anchor.thickness=0.2 m"}, 20);
    EXPECT_NEAR(twenty, 0.5 * ten, 1e-12);
    EXPECT_GT(std::fabs(five), std::fabs(ten));
}

TEST(MeshError, IsLinearBetweenTheAnglesAndHeldBeyond) {
    EXPECT_NEAR(error({}, 25), 0.5 * (error({}, 20) + error({}, 30)), 1e-12);
    EXPECT_EQ(error({}, 45), error({}, 40));
    EXPECT_EQ(error({}, 15), error({}, 20));
}

TEST(MeshError, IsUnknownWhereTheBookHoldsNothing) {
    EXPECT_TRUE(std::isnan(error({"domain.edges=on_nodes"})));
    EXPECT_TRUE(std::isnan(error({"domain.points_per_cell=9"})));
    EXPECT_TRUE(std::isnan(error({}, 0)));
}

TEST(MeshError, KnowsWhatABodyIsLike) {
    const auto body = [](const char* table) {
        return mesh_case(scene::parse_scene(std::string(R"(
[domain]
width = "4 m"
depth = "3 m"
cell = "0.1 m"
[ground]
law = "mohr_coulomb"
[[body]]
)") + table,
                                            "s.toml", {}));
    };
    EXPECT_EQ(body("shape = \"rectangle\"\ncentre = [\"0 m\", \"3.2 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"
                   "velocity = [\"0 m/s\", \"-0.01 m/s\"]\ntravel = \"0.01 m\""),
              MeshCase::footing);
    EXPECT_EQ(body("shape = \"rectangle\"\ncentre = [\"0 m\", \"0.2 m\"]\nsize = [\"1 m\", \"0.4 m\"]\n"
                   "velocity = [\"0 m/s\", \"0.01 m/s\"]\ntravel = \"0.01 m\""),
              MeshCase::trapdoor);
    EXPECT_EQ(body("shape = \"rectangle\"\ncentre = [\"0.2 m\", \"2.6 m\"]\nsize = [\"0.4 m\", \"1.2 m\"]\n"
                   "velocity = [\"0.01 m/s\", \"0 m/s\"]\ntravel = \"0.01 m\""),
              MeshCase::wall_passive);
    EXPECT_EQ(body("shape = \"circle\"\ncentre = [\"0 m\", \"1.5 m\"]\nradius = \"0.5 m\"\n"
                   "velocity = [\"0 m/s\", \"0.01 m/s\"]\ntravel = \"0.01 m\""),
              std::nullopt);
}

}  // namespace
}  // namespace sandgraph::results
