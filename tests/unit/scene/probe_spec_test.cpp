#include "scene/probe_spec.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace sandgraph::scene {
namespace {

class ProbeRecipe : public testing::Test {
  protected:
    ~ProbeRecipe() override { std::filesystem::remove(file_); }
    ProbeSpec read(const std::string& text) const {
        std::ofstream(file_) << text;
        return read_probe(file_.string());
    }
    std::string refused(const std::string& text) const {
        try {
            read(text);
        } catch (const InputError& error) {
            return std::string(error.what()).substr(file_.parent_path().string().size());
        }
        return "accepted";
    }
    std::filesystem::path file_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".toml");
};

TEST_F(ProbeRecipe, ReadsPackingsAndPaths) {
    const ProbeSpec spec = read(
        "seed = 7\n[packings]\nseeds = 3\npressure_min = \"1 kPa\"\nporosities = [0.15, 0.2]\n"
        "[paths]\nmixed = 12\ntwin_every = 0\n[grains]\ncount = 100\nfriction_angle = \"30 deg\"\n");
    EXPECT_EQ(spec.seed, 7u);
    EXPECT_EQ(spec.packings.seeds, 3);
    EXPECT_EQ(spec.packings.pressure_min, 1000);
    EXPECT_EQ(spec.packings.porosities, (std::vector<double>{0.15, 0.2}));
    EXPECT_EQ(spec.paths.mixed, 12);
    EXPECT_EQ(spec.grains.count, 100);
}

TEST_F(ProbeRecipe, RefusesWhatItDoesNotKnowAndWhatDoesNotFit) {
    EXPECT_NE(refused("[paths]\nmixt = 3\n").find("mixed"), std::string::npos);
    // Seed and density of the packings are the recipe's own; a key that would be ignored is unknown.
    EXPECT_NE(refused("[grains]\nseed = 3\n"), "accepted");
    EXPECT_NE(refused("[grains]\ndensity = \"loose\"\n"), "accepted");
    EXPECT_NE(refused("[packings]\npressure_max = \"0.1 kPa\"\n").find(".toml:2: packings.pressure_max"),
              std::string::npos);
    EXPECT_NE(refused("[paths]\nlength_max = 1e-5\n").find("length_min"), std::string::npos);
    EXPECT_NE(refused("[packings]\npressure_max = \"2 MPa\"\n").find("pressure_stop"), std::string::npos);
    EXPECT_NE(refused("[paths]\nflow = 0\nflow_rows = 500\n").find(".toml:3: paths.flow_rows"),
              std::string::npos);
    EXPECT_NE(refused("[rve]\nupdate_tolerance = 0.1\n").find("every increment"), std::string::npos);
    EXPECT_NE(refused("[grains]\nradius_min = \"8 mm\"\n").find("radius_max"), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::scene
