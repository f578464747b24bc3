#include "scene/element_test_spec.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "scene/recipe_spec.hpp"

namespace sandgraph::scene {
namespace {

class InputFiles : public testing::Test {
  protected:
    InputFiles() { std::filesystem::create_directories(folder_); }
    ~InputFiles() override { std::filesystem::remove_all(folder_); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    std::string refused(const std::string& text) const {
        try {
            read_element_test(write("t.toml", text));
        } catch (const InputError& error) {
            return std::string(error.what()).substr(folder_.string().size() + 1);
        }
        return "accepted";
    }
    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                    testing::UnitTest::GetInstance()->current_test_info()->name();
};

using ElementTestFile = InputFiles;
using RecipeFile = InputFiles;

constexpr const char* segment = "[[segment]]\nvelocity_gradient = [[0.1, 0.2], [0, -0.1]]\nsteps = 50\n";

TEST_F(ElementTestFile, ReadsAPath) {
    const auto spec =
        read_element_test(write("t.toml", std::string("kind = \"path\"\nmode = \"fast\"\n"
                                                      "time_step = \"2e-5 s\"\nrelax_steps = 7\n") +
                                              segment + segment));
    EXPECT_EQ(spec.kind, TestKind::path);
    EXPECT_EQ(spec.mode, dem::Kernel::fast);
    EXPECT_EQ(spec.path.time_step, 2e-5);
    EXPECT_EQ(spec.path.relax_steps, 7);
    ASSERT_EQ(spec.path.segments.size(), 2u);
    EXPECT_EQ(spec.path.segments[1].velocity_gradient, (Mat2() << 0.1, 0.2, 0, -0.1).finished());
    EXPECT_EQ(spec.path.segments[1].steps, 50);
}

TEST_F(ElementTestFile, ReadsAShearAtConstantMeanStress) {
    const auto spec = read_element_test(
        write("t.toml", "kind = \"simple_shear\"\nmean_stress = \"20 kPa\"\nshear_strain = 10\n"));
    EXPECT_EQ(spec.kind, TestKind::simple_shear);
    EXPECT_EQ(spec.shear.mean_stress, 20e3);
    EXPECT_EQ(spec.shear.shear_strain, 10);
    EXPECT_EQ(refused("kind = \"simple_shear\"\nshear_rate = \"1e5 1/s\"\n").substr(0, 9), "t.toml:2:");
}

TEST_F(ElementTestFile, ReadsSegmentsFromCsvBesideIt) {
    write("p.csv", "\xEF\xBB\xBFLxx, Lxy,Lyx,Lyy,steps\r\n+0.1,0,0,-0.1,100 \r\n\n# shear\n0, 0.4,0,0,2e3\n");
    const auto spec = read_element_test(write("t.toml", "kind = \"path\"\nsegments = \"p.csv\"\n"));
    ASSERT_EQ(spec.path.segments.size(), 2u);
    EXPECT_EQ(spec.path.segments[1].velocity_gradient(0, 1), 0.4);
    EXPECT_EQ(spec.path.segments[1].steps, 2000);
}

TEST_F(ElementTestFile, RefusesBadCsvAtItsLine) {
    const std::string path = "kind = \"path\"\nsegments = \"p.csv\"\n";
    write("p.csv", "Lxx,Lxy,Lyx,Lyy,steps\n0.1,0,0,nan,100\n");
    EXPECT_EQ(refused(path).rfind("p.csv:2: ", 0), 0u) << refused(path);
    write("p.csv", "Lxx,Lxy,Lyx,Lyy\n");
    EXPECT_EQ(refused(path).rfind("p.csv:1: ", 0), 0u);
    write("p.csv", "Lxx,Lxy,Lyx,Lyy,steps\n0.1,0,0,0,1.5\n");
    EXPECT_EQ(refused(path).rfind("p.csv:2: ", 0), 0u);
    write("p.csv", "Lxx,Lxy,Lyx,Lyy,steps\n");
    EXPECT_EQ(refused(path).rfind("p.csv: no segments", 0), 0u);
}

TEST_F(ElementTestFile, ReadsABiaxialTest) {
    const auto spec = read_element_test(write("t.toml",
                                              "kind = \"biaxial\"\nconfining_pressure = \"32 kPa\"\n"
                                              "axial_rate = \"0.2 1/s\"\naxial_strain = 0.1\n"));
    EXPECT_EQ(spec.kind, TestKind::biaxial);
    EXPECT_EQ(spec.biaxial.confining_pressure, 32e3);
    EXPECT_EQ(spec.biaxial.axial_rate, 0.2);
    EXPECT_EQ(spec.biaxial.axial_strain, 0.1);
}

TEST_F(ElementTestFile, TakesTheMaterialOfThePackingUnlessTold) {
    dem::Material material;
    material.damping = 0.5;
    const std::string file = write("t.toml", "kind = \"isotropic\"\n[grains]\nrolling_limit = 0\n");
    const auto spec = read_element_test(file, material);
    EXPECT_EQ(spec.material.damping, 0.5);
    EXPECT_EQ(spec.material.rolling_limit, 0);
}

TEST_F(ElementTestFile, TakesTheFastKernelUnlessTold) {
    EXPECT_EQ(read_element_test(write("t.toml", "kind = \"biaxial\"\n")).mode, dem::Kernel::fast);
    EXPECT_EQ(read_element_test(write("t.toml", "kind = \"biaxial\"\nmode = \"reference\"\n")).mode,
              dem::Kernel::reference);
}

TEST_F(ElementTestFile, RefusesSteppingThatItDoesNotFollow) {
    const std::string stepping = "[rve]\ninertial_number_max = 1e-3\n";
    EXPECT_EQ(refused("kind = \"biaxial\"\n" + stepping).rfind("t.toml:3: rve.inertial_number_max", 0), 0u);
    EXPECT_EQ(refused(std::string("kind = \"path\"\nmode = \"reference\"\n") + segment + stepping)
                  .rfind("t.toml:7: rve.inertial_number_max", 0),
              0u);
    EXPECT_EQ(refused(std::string("kind = \"path\"\n") + segment + stepping), "accepted");
    for (const char* key : {"update_tolerance = 0.1", "predictor = \"elastic\"", "steps_max = 40"})
        EXPECT_NE(refused(std::string("kind = \"path\"\n") + segment + "[rve]\n" + key + "\n")
                      .find("every increment"),
                  std::string::npos)
            << key;
}

TEST_F(ElementTestFile, RefusesKeysOfAnotherKind) {
    EXPECT_EQ(refused("kind = \"biaxial\"\nsample_every = 3\n").rfind("t.toml:2: unknown key", 0), 0u);
    EXPECT_EQ(refused("\nkind = \"biaxal\"\n").rfind("t.toml:2: kind = \"biaxal\"", 0), 0u);
    EXPECT_EQ(refused("mode = \"fast\"\n").rfind("t.toml: no key kind", 0), 0u);
}

TEST_F(ElementTestFile, RefusesAnIncompletePath) {
    EXPECT_EQ(refused("kind = \"path\"\n").rfind("t.toml: no segments", 0), 0u);
    EXPECT_EQ(refused("kind = \"path\"\n[[segment]]\nsteps = 3\n").rfind("t.toml:2: [[segment]] without", 0),
              0u);
    EXPECT_EQ(refused("kind = \"path\"\n[[segment]]\nsteps = 3\nvelocity_gradient = [1, 2]\n")
                  .rfind("t.toml:4: ", 0),
              0u);
    EXPECT_EQ(refused("kind = \"path\"\n[[segment]]\nstep = 3\n").rfind("t.toml:3: unknown key step", 0), 0u);
}

TEST_F(ElementTestFile, RefusesRatesThatNoGrainFollows) {
    const std::string path =
        "kind = \"path\"\n\n[[segment]]\nvelocity_gradient = [[0, 1e6], [0, 0]]\nsteps = 5\n";
    EXPECT_EQ(refused(path).rfind("t.toml:3: a rate of 1e+06 1/s (it strains the sample by 10", 0), 0u)
        << refused(path);
    const std::string biaxial = "kind = \"biaxial\"\naxial_rate = \"2000 1/s\"\n";
    EXPECT_EQ(refused(biaxial).rfind("t.toml:2: a rate of 2000 1/s", 0), 0u) << refused(biaxial);
}

TEST_F(RecipeFile, HasTheGrainsOfAScene) {
    const auto recipe =
        read_recipe(write("r.toml", "pressure = \"32 kPa\"\n[grains]\ndensity = \"loose\"\ncount = 200\n"));
    EXPECT_EQ(recipe.pressure, 32e3);
    EXPECT_EQ(recipe.grains.count, 200);
    EXPECT_EQ(recipe.grains.target_porosity, 0.20);
    EXPECT_THROW(read_recipe(write("r.toml", "pressure = 32\n")), InputError);
}

}  // namespace
}  // namespace sandgraph::scene
