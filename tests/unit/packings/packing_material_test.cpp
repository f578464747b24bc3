#include "packings/packing_material.hpp"

#include <numbers>

#include "dem/packing/csv.hpp"
#include "io/packing_file.hpp"
#include "packings/base_packing.hpp"
#include "scene/read_scene.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/scene_hash.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::packings {
namespace {

constexpr double kFriction = 35 * std::numbers::pi / 180;

// Sixteen disks that just touch, of sand that is not Table 1's.
class PackingFile : public testing::Test {
  protected:
    PackingFile() {
        io::PackingRecord record;
        record.packing.H = 0.08 * Mat2::Identity();
        for (int g = 0; g < 16; ++g) {
            record.packing.x.push_back(0.01 + 0.02 * (g % 4)),
                record.packing.y.push_back(0.01 + 0.02 * (g / 4));
            record.packing.r.push_back(0.01);
        }
        record.material.friction_angle = kFriction, record.material.young = 200e6;
        record.material.depth = 0.2, record.material.density = 2600;
        record.material.rolling_form = dem::RollingForm::total;
        io::write_packing(folder_ / "p.h5", record);
        io::write_packing(folder_ / "CAPITAL.H5", record);
        dem::write_packing_csv(folder_ / "p.csv", record.packing, "{}");
        dem::write_packing_csv(folder_ / "P.CSV", record.packing, "{}");
    }
    scene::Grains grains(const std::string& keys) const {
        scene::Scene scene = scene::parse_scene("[grains]\n" + keys, (folder_ / "s.toml").string(),
                                                std::vector<std::string>{});
        take_packing_material(scene.ground.grains, scene.given);
        return scene.ground.grains;
    }
    std::string refused(const std::string& keys) const {
        return test::message_of<InputError>([&] { grains(keys); });
    }
    const test::Scratch folder_;
};

TEST_F(PackingFile, BringsItsOwnMaterial) {
    for (const char* name : {"p.h5", "CAPITAL.H5"}) {
        const scene::Grains g = grains(std::string("packing = \"") + name + "\"\n");
        EXPECT_EQ(g.material.friction_angle, kFriction);
        EXPECT_EQ(g.material.young, 200e6);
        EXPECT_EQ(g.material.depth, 0.2);
        EXPECT_EQ(g.material.density, 2600);
        EXPECT_EQ(g.material.rolling_form, dem::RollingForm::total);
        EXPECT_EQ(g.count, 16);
        EXPECT_NEAR(g.target_porosity, 1 - std::numbers::pi / 4, 1e-12);
        EXPECT_EQ(g.density, "custom");
    }
}

TEST_F(PackingFile, RefusesAKeyThatContradictsIt) {
    for (const char* key : {"friction_angle = \"23 deg\"", "young = \"800 MPa\"", "depth = \"0.1 m\"",
                            "rolling_form = \"incremental\"", "grain_density = \"2650 kg/m3\""}) {
        const std::string error = refused(std::string("packing = \"p.h5\"\n") + key + "\n");
        EXPECT_NE(error.find("s.toml:3: grains."), std::string::npos) << error;
        EXPECT_NE(error.find("brings its own material"), std::string::npos) << error;
    }
}

TEST_F(PackingFile, TakesAKeyThatSaysTheSame) {
    EXPECT_NO_THROW(grains("packing = \"p.h5\"\nfriction_angle = \"35 deg\"\nyoung = \"0.2 GPa\"\n"));
}

TEST_F(PackingFile, WithoutAMaterialTakesTheKeys) {
    for (const char* name : {"p.csv", "P.CSV"}) {
        const scene::Grains g =
            grains(std::string("packing = \"") + name + "\"\nfriction_angle = \"30 deg\"\n");
        EXPECT_EQ(g.material.friction_angle, 30 * std::numbers::pi / 180);
        EXPECT_EQ(g.material.young, dem::Material{}.young);
        EXPECT_EQ(g.count, 16);
    }
}

TEST_F(PackingFile, IsRefusedBesideKeysOfARecipeInARecipe) {
    test::overwrite(folder_ / "r.toml", "pressure = \"20 kPa\"\n[grains]\npacking = \"p.h5\"\nseed = 3\n");
    const std::string error =
        test::message_of<InputError>([&] { scene::read_recipe((folder_ / "r.toml").string()); });
    EXPECT_NE(error.find("r.toml:4: grains.seed = 3"), std::string::npos) << error;
}

TEST(ChangedMaterial, IsToldKeyByKey) {
    dem::Material used;
    EXPECT_EQ(changed_material(used, {}), "");
    used.rolling_limit = 0.3;
    EXPECT_EQ(changed_material(used, {}), "grains.rolling_limit = 0.3 instead of the packing's 0.05");
}

}  // namespace
}  // namespace sandgraph::packings
