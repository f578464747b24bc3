// Every TOML of configs/ is run for a few steps, or planned, and gives its stored numbers. One that is in no
// table below fails AllAreTested: add it to the table of its kind with what it gives.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "laboratory/probe_plan.hpp"
#include "scene/train_spec.hpp"
#include "simulation/sweep_plan.hpp"
#include "support/paths.hpp"
#include "tests/support/subprocess.hpp"

namespace sandgraph::app {
namespace {

namespace fs = std::filesystem;

const fs::path configs = fs::path(sandgraph::test::source_file("/configs"));

constexpr double same = 1e-6;     // relative: other instruction sets sum in another order
constexpr double packing = 0.05;  // where grains answer: another rounding makes another packing

// To d/B = 0.002 on Mohr-Coulomb ground, whose answers are no matter of packings.
struct SceneExample {
    const char* file;
    double points, steps, load;  // load [N/m] of the last row
};
const SceneExample scenes[] = {
    {"quick.toml", 1052, 752, 54184.4041},
    {"anchor_horizontal.toml", 8075, 940, 39898.4596},
    {"anchor_vertical.toml", 9590, 940, 46527.7856},
    {"paper/deep.toml", 13995, 940, 49619.644800809416},
    {"paper/horizontal.toml", 7995, 940, 41187.20640759507},
    {"paper/vertical.toml", 9590, 940, 46752.78212598857},
    {"exact/anchor.toml", 1876, 4147, 151654.0855},
    {"exact/anchor_vertical.toml", 1380, 15481, 34589.0396863},
    {"exact/footing.toml", 1830, 47000, 178268.422928},
    {"exact/footing_surcharge.toml", 3240, 19241, 159941.448419},
    {"exact/wall_passive.toml", 660, 13423, 37739.5020091},
    {"exact/wall_active.toml", 380, 10768, -3069.4264},
    {"exact/trapdoor.toml", 1230, 1660, 165439.9192},
};

// Porosity of the packing at its 10 kPa.
struct RecipeExample {
    const char* file;
    double porosity;
};
const RecipeExample recipes[] = {{"laboratory/rve_dense.toml", 0.16}, {"laboratory/rve_loose.toml", 0.20}};

// The test's own settings, but for the length of its path, on the public dense packing at 32 kPa.
struct ElementExample {
    const char *file, *key, *shortened;
    double steps, sxx, syy, porosity;  // of the last row [Pa]
    double tolerance;                  // relative, on the stresses
};
const ElementExample elements[] = {
    {"laboratory/biaxial.toml", "axial_strain", "0.005", 5002, 64009.06, 170779.6, 0.15695634, 0.01},
    {"laboratory/path.toml", "steps", "1000", 1000, 17913.7192, 45396.4037, 0.16056236703, 3e-4},
    {"laboratory/simple_shear.toml", "shear_strain", "0.02", 4002, 19766.456, 20239.075, 0.16571148, 0.01},
};

const std::set<std::string> others = {"models/probe.toml", "models/probe_guard.toml", "models/train.toml",
                                      "models/train_friction.toml", "sweeps/anchor_table.toml"};

TEST(Examples, AllAreTested) {
    std::set<std::string> tested = others, there;
    for (const SceneExample& e : scenes) tested.insert(e.file);
    for (const RecipeExample& e : recipes) tested.insert(e.file);
    for (const ElementExample& e : elements) tested.insert(e.file);
    for (const auto& entry : fs::recursive_directory_iterator(configs))
        if (entry.path().extension() == ".toml") there.insert(fs::relative(entry.path(), configs).string());
    EXPECT_EQ(there, tested);
}

// Column of the last row of a table in CSV; lines with # apart.
double last(const std::string& csv, const std::string& column) {
    std::istringstream in(csv);
    std::string names, row;
    for (std::string line; std::getline(in, line);)
        if (!line.starts_with('#')) (names.empty() ? names : row) = line;
    std::istringstream name(names), value(row);
    for (std::string n, v; std::getline(name, n, ',') && std::getline(value, v, ',');)
        if (n == column) return std::stod(v);
    return NAN;
}

double number(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\":");
    return at == std::string::npos ? NAN : std::stod(json.substr(at + key.size() + 3));
}

std::string name_of(std::string file) {
    file = file.substr(0, file.size() - std::string(".toml").size());
    for (char& c : file)
        if (c == '/') c = '_';
    return file;
}

void ran(const Shell::Outcome& outcome) { ASSERT_EQ(outcome.exit_code, 0) << outcome.err; }

class OfScene : public testing::TestWithParam<SceneExample> {};

TEST_P(OfScene, GivesItsLoad) {
    const SceneExample& e = GetParam();
    const Shell shell("example_" + name_of(e.file));
    ran(
        shell.run(fmt::format("run '{}' -o out --threads 2 --until 0.002 --set ground.law=mohr_coulomb "
                              "--set output.pictures=false --set output.load_every=0.0005",
                              (configs / e.file).string())));
    const std::string summary = shell.read("out/summary.json");
    EXPECT_EQ(number(summary, "points"), e.points);
    EXPECT_EQ(number(summary, "steps"), e.steps);
    EXPECT_NEAR(last(shell.read("out/load.csv"), "load_N_per_m"), e.load, same * std::fabs(e.load));
}

INSTANTIATE_TEST_SUITE_P(Configs, OfScene, testing::ValuesIn(scenes),
                         [](const auto& e) { return name_of(e.param.file); });

// The first scene of the README with its own grains, and with the surrogate that is found without being
// named.
TEST(OfQuickScene, GrainsAndSurrogateGiveItsLoad) {
    const Shell shell("example_quick");
    setenv("SANDGRAPH_CACHE", shell.path("cache").c_str(), 1);
    for (const auto& [mode, load] : {std::pair{"full", 97475.8}, std::pair{"screening", 96331.1}}) {
        ran(
            shell.run(fmt::format("run '{}' -o {} --mode {} --threads 2 --until 0.004 "
                                  "--set output.pictures=false --set output.load_every=0.0005",
                                  (configs / "quick.toml").string(), mode, mode)));
        const std::string folder = mode, summary = shell.read(folder + "/summary.json");
        EXPECT_NEAR(last(shell.read(folder + "/load.csv"), "load_N_per_m"), load, packing * load) << mode;
        EXPECT_GT(number(summary, "rve_updates"), 1000) << mode;
        EXPECT_EQ(number(summary, "surrogate_updates") > 1000, folder == "screening");
    }
    unsetenv("SANDGRAPH_CACHE");
}

class OfRecipe : public testing::TestWithParam<RecipeExample> {};

TEST_P(OfRecipe, MakesThePackingAskedFor) {
    const RecipeExample& e = GetParam();
    const Shell shell("example_" + name_of(e.file));
    ran(shell.run(fmt::format("rve prepare '{}' -o p.h5", (configs / e.file).string())));
    const std::string info = shell.run("info p.h5").out;
    std::smatch found;
    ASSERT_TRUE(std::regex_search(info, found, std::regex(R"(porosity = ([0-9.]+))"))) << info;
    EXPECT_NEAR(std::stod(found[1]), e.porosity, 0.002);  // the recipe's own tolerance
    EXPECT_NE(info.find("float64 (400)"), std::string::npos) << info;
}

INSTANTIATE_TEST_SUITE_P(Configs, OfRecipe, testing::ValuesIn(recipes),
                         [](const auto& e) { return name_of(e.param.file); });

// The text with another value of a key.
std::string with(const std::string& text, const std::string& key, const std::string& value) {
    const std::regex line("(^|\n)" + key + " *= *[^ \n]+");
    EXPECT_TRUE(std::regex_search(text, line)) << key;
    return std::regex_replace(text, line, "$1" + key + " = " + value);
}

class OfElement : public testing::TestWithParam<ElementExample> {};

TEST_P(OfElement, GivesItsLastRow) {
    const ElementExample& e = GetParam();
    const Shell shell("example_" + name_of(e.file));
    std::ifstream in(configs / e.file);
    shell.write("t.toml", with((std::ostringstream() << in.rdbuf()).str(), e.key, e.shortened));
    ran(shell.run("rve test t.toml --packing " + sandgraph::test::test_data("/yade/packing_dense_p32.csv") +
                  " -o t.csv"));
    const std::string csv = shell.read("t.csv");
    EXPECT_NEAR(last(csv, "step"), e.steps, 2);  // the consolidation before it ends by its stress
    EXPECT_NEAR(last(csv, "sxx"), e.sxx, e.tolerance * e.syy);
    EXPECT_NEAR(last(csv, "syy"), e.syy, e.tolerance * e.syy);
    EXPECT_NEAR(last(csv, "n"), e.porosity, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Configs, OfElement, testing::ValuesIn(elements),
                         [](const auto& e) { return name_of(e.param.file); });

TEST(OfProbe, PlansItsPackingsAndPaths) {
    const laboratory::ProbePlan plan =
        laboratory::plan_probe(scene::read_probe((configs / "models/probe.toml").string()));
    EXPECT_EQ(plan.packings.size(), 6u * 3 * 6);
    EXPECT_EQ(plan.jobs.size(), 1650u);
    EXPECT_EQ(plan.histories.size(), 2310u);  // with four twins of every tenth
}

TEST(OfSweep, PlansItsRunsEachAScene) {
    const simulation::SweepPlan plan =
        simulation::plan_sweep((configs / "sweeps/anchor_table.toml").string(), "out");
    ASSERT_EQ(plan.runs.size(), 24u);
    std::set<std::string> scenes;
    for (const simulation::SweepRun& run : plan.runs) {
        EXPECT_EQ(run.scene.mode, scene::Mode::screening);
        scenes.insert(run.scene_hash);
    }
    EXPECT_EQ(scenes.size(), 24u);
    EXPECT_EQ(plan.runs.back().scene.anchor.embedment_ratio, 5);
    EXPECT_EQ(plan.runs.back().scene.domain.width, 16);
    EXPECT_EQ(plan.runs.back().scene.ground.grains.density, "loose");
}

TEST(OfTraining, IsReadAndFindsWhatItNames) {
    const scene::TrainSpec first = scene::read_train((configs / "models/train.toml").string()),
                           friction = scene::read_train((configs / "models/train_friction.toml").string());
    for (const scene::TrainSpec& spec : {first, friction}) {
        EXPECT_TRUE(fs::equivalent(spec.probe, configs / "models/probe.toml")) << spec.probe;
        EXPECT_EQ(spec.members, 4);
        EXPECT_EQ(spec.training.batch, 64);
        EXPECT_EQ(spec.strain_max, 3);
        EXPECT_EQ(spec.rung, scene::TrainRung::learned);
    }
    EXPECT_EQ(first.training.epochs, 150);
    EXPECT_EQ(friction.training.epochs, 40);
    EXPECT_TRUE(first.start.empty());
    EXPECT_TRUE(fs::equivalent(friction.start, configs / "models/table1.surrogate.h5")) << friction.start;
    EXPECT_TRUE(friction.training.scale.friction && friction.measured_critical);
}

}  // namespace
}  // namespace sandgraph::app
