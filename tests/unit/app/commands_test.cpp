#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/element_test_keys.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/scene_keys.hpp"
#include "scene/train_spec.hpp"
#include "tests/unit/app/bad_input.hpp"

namespace sandgraph::app {
namespace {

std::string compression(const char* mode) {
    return std::string("kind = \"path\"\nmode = \"") + mode +
           "\"\nrelax_steps = 0\nsample_every = 100\n[[segment]]\nvelocity_gradient = [[-0.1, 0], [0, "
           "-0.1]]\n"
           "steps = 1000\n[grains]\ndamping = 0.7\n";
}

// Value of a column in the last row of a CSV with one '#' line.
double last(const std::string& csv, const std::string& column) {
    std::istringstream in(csv);
    std::string metadata, names, row, line;
    std::getline(in, metadata);
    std::getline(in, names);
    while (std::getline(in, line)) row = line;
    std::istringstream name(names), value(row);
    for (std::string n, v; std::getline(name, n, ',') && std::getline(value, v, ',');)
        if (n == column) return std::stod(v);
    return NAN;
}

TEST(RveTest, SquareLatticeCarriesItsContactStiffness) {
    const Shell shell("lattice");
    shell.write("p.csv", lattice());
    for (const char* mode : {"reference", "fast"}) {
        shell.write("t.toml", compression(mode));
        const auto outcome = shell.run("rve test t.toml --packing p.csv -o out.csv --threads 2");
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        // sigma_xx = k_n overlap / (2 r h) = E r eps 2 r / (2 r h) = E r eps / h at strain eps = 1e-3.
        const double expected = 800e6 * 0.01 * 1e-3 / 0.1;
        EXPECT_NEAR(last(shell.read("out.csv"), "sxx"), expected, 0.01 * expected) << mode;
        EXPECT_NEAR(last(shell.read("out.csv"), "syy"), expected, 0.01 * expected) << mode;
        EXPECT_EQ(last(shell.read("out.csv"), "Nc"), 32) << mode;
        EXPECT_EQ(last(shell.read("out.csv"), "step"), 1000) << mode;
    }
}

TEST(RveTest, GivesTheSameBytesAgain) {
    const Shell shell("repeat");
    shell.write("p.csv", lattice());
    shell.write("t.toml", compression("fast"));
    shell.run("rve test t.toml --packing p.csv -o a.csv --threads 1");
    shell.run("rve test t.toml --packing p.csv -o b.csv --threads 2");
    EXPECT_FALSE(shell.read("a.csv").empty());
    EXPECT_EQ(shell.read("a.csv"), shell.read("b.csv"));
}

TEST(RveTest, WritesToTheTerminalWithoutAnOutputFile) {
    const Shell shell("stdout");
    shell.write("p.csv", lattice());
    shell.write("t.toml", compression("reference"));
    EXPECT_NE(shell.run("rve test t.toml --packing p.csv").out.find("step,t,Fxx"), std::string::npos);
}

TEST(RveTest, AppendsWhereTheTerminalIsAFile) {
    const Shell shell("append");
    shell.write("p.csv", lattice());
    shell.write("t.toml", compression("reference"));
    shell.write("all.csv", "earlier\n");
    ASSERT_EQ(shell.run("rve test t.toml --packing p.csv >>all.csv && true").exit_code, 0);
    EXPECT_EQ(shell.read("all.csv").rfind("earlier\n# {", 0), 0u);
}

TEST(RvePrepare, MakesWhatTheTestReads) {
    const Shell shell("prepare");
    shell.write("r.toml", "pressure = \"20 kPa\"\n[grains]\ncount = 60\n");
    const auto made = shell.run("rve prepare r.toml -o p.h5 --csv p.csv");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    shell.write("t.toml", "kind = \"path\"\n[[segment]]\nvelocity_gradient = [[0, 0], [0, 0]]\nsteps = 10\n");
    for (const char* packing : {"p.h5", "p.csv"}) {
        const auto tested = shell.run(std::string("rve test t.toml -o out.csv --packing ") + packing);
        ASSERT_EQ(tested.exit_code, 0) << tested.err;
        EXPECT_NEAR(last(shell.read("out.csv"), "sxx"), 20e3, 0.1 * 20e3) << packing;
    }
    EXPECT_NE(shell.run("info p.h5").out.find("contacts"), std::string::npos);
}

TEST(RveBench, PrintsWhatScriptsRead) {
    const Shell shell("bench");
    shell.write("p.csv", lattice());
    double time = 0;
    int contacts = 0;
    for (const char* kernel : {"", " --reference"}) {
        const std::string out = shell.run(std::string("rve bench --packing p.csv --steps 1000") + kernel).out;
        ASSERT_EQ(std::sscanf(out.c_str(), "us_per_step %lf contacts %d", &time, &contacts), 2) << out;
        EXPECT_GT(time, 0);
    }
}

// Every key of the table stands in `told` at the head of a line, below the name of its table.
void expect_all_named(const scene::KeyTable& table, const std::string& told) {
    ASSERT_FALSE(table.keys().empty());
    for (const scene::Key& key : table.keys()) {
        const std::size_t section = key.section.empty() ? 0 : told.find("\n[" + key.section + "]\n");
        ASSERT_NE(section, std::string::npos) << key.section << " in\n" << told;
        const std::size_t end = std::min(told.find("\n[", section + 1), told.size());
        const std::string lines = "\n" + told.substr(section, end - section);
        // Behind a '#' where it would have no effect beside the other defaults.
        EXPECT_TRUE(lines.find("\n" + key.name + " = ") != std::string::npos ||
                    lines.find("\n# " + key.name + " = ") != std::string::npos)
            << key.full_name() << " in\n"
            << told;
    }
}

TEST(Keys, NameEveryTable) {
    const Shell shell("keys");
    const auto outcome = shell.run("keys");
    EXPECT_EQ(outcome.exit_code, 0);
    scene::Scene scene;
    expect_all_named(scene::scene_keys(scene), outcome.out);
    scene::RecipeSpec recipe;
    expect_all_named(scene::recipe_keys(recipe), shell.run("keys recipe").out);
    scene::ProbeSpec probe;
    expect_all_named(scene::probe_keys(probe), shell.run("keys probe").out);
    scene::TrainSpec train;
    expect_all_named(scene::train_keys(train), shell.run("keys train").out);
    const std::vector<std::string> kinds = scene::test_kind_names();
    ASSERT_GE(kinds.size(), 4u);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        scene::ElementTestSpec spec;
        spec.kind = static_cast<scene::TestKind>(kind);
        expect_all_named(scene::element_test_keys(spec), shell.run("keys " + kinds[kind]).out);
    }
}

// The ground drives the plate at first: there is no work of the plate to compare with.
TEST(EnergyRatio, OverNoWorkIsADashAndNull) {
    const Shell shell("energy");
    shell.write(
        "s.toml",
        "[domain]\nwidth = \"4 m\"\ndepth = \"4 m\"\ncell = \"0.125 m\"\n[anchor]\nembedment_ratio = 2\n"
        "thickness = \"0.125 m\"\npull_to = 0.02\nfriction_angle = \"0 deg\"\n[ground]\nlaw = "
        "\"mohr_coulomb\"\n[continuum]\nfriction_angle = \"0 deg\"\n[output]\nframes = [0]\n");
    const auto rest = shell.run("run s.toml -o rest --threads 1 --until 0.0001");
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_NE(rest.out.find("plate's work: -"), std::string::npos) << rest.out;
    EXPECT_NE(shell.read("rest/summary.json").find("\"kinetic_to_strain_energy_max\": null"),
              std::string::npos);
    const auto told = shell.run("run s.toml -o out --threads 1");
    ASSERT_EQ(told.exit_code, 0) << told.err;
    EXPECT_EQ((rest.out + rest.err + told.out + told.err).find("e+3"), std::string::npos) << told.out;
}

}  // namespace
}  // namespace sandgraph::app
