#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/app/bad_input.hpp"

namespace sandgraph::app {
namespace {

constexpr const char* header = "# {}\n# cell\n# 0.1 0 0 0.1\nid,x,y,r\n";
constexpr const char* path_test =
    "kind = \"path\"\nrelax_steps = 0\n[[segment]]\nvelocity_gradient = [[-0.1, 0], [0, -0.1]]\nsteps = 10\n";

TEST(BadInput, UnknownKeyOfATest) {
    const Shell shell("unknown_key");
    shell.write("t.toml", "kind = \"biaxial\"\naxial_strian = 0.1\n");
    shell.write("p.csv", lattice());
    expect_bad_input(shell.run("rve test t.toml --packing p.csv -o out.csv"), "t.toml:2", "axial_strian");
    EXPECT_EQ(shell.files(), 2);
}

TEST(BadInput, MissingAndWrongUnitsOfARecipe) {
    const Shell shell("unit");
    shell.write("r.toml", "pressure = 32\n");
    expect_bad_input(shell.run("rve prepare r.toml -o p.h5"), "r.toml:1", "write \"32 kPa\"");
    shell.write("r.toml", "\npressure = \"32 deg\"\n");
    expect_bad_input(shell.run("rve prepare r.toml -o p.h5 --csv p.csv"), "r.toml:2", "unit of angle");
    EXPECT_EQ(shell.files(), 1);
}

TEST(BadInput, GuardOfATrainingThatStartsFromNothing) {
    const Shell shell("guard");
    shell.write("log.h5", ""), shell.write("guard.h5", "");
    shell.write("t.toml", "[data]\nlogs = \"log.h5\"\nguard = \"guard.h5\"\n");
    const auto refused = shell.run("train t.toml -o m.h5");
    expect_bad_input(refused, "t.toml:3", "guards what model.start has learnt");
    EXPECT_NE(refused.err.find("; leave it out, or write start = "), std::string::npos) << refused.err;
    EXPECT_EQ(shell.files(), 3);
}

TEST(BadInput, PackingWithNaN) {
    const Shell shell("nan");
    shell.write("t.toml", path_test);
    shell.write("p.csv", std::string(header) + "0,0.05,0.05,0.01\n1,nan,0.02,0.01\n");
    expect_bad_input(shell.run("rve test t.toml --packing p.csv -o out.csv"), "p.csv:6", "not finite");
    EXPECT_EQ(shell.files(), 2);
}

TEST(BadInput, PackingWithOneDiskInAnother) {
    const Shell shell("overlap");
    shell.write("t.toml", path_test);
    shell.write("p.csv", std::string(header) + "0,0.05,0.05,0.01\n1,0.052,0.05,0.01\n");
    expect_bad_input(shell.run("rve test t.toml --packing p.csv -o out.csv"), "p.csv:6", "overlap");
    EXPECT_EQ(shell.files(), 2);
}

std::string test_of(const std::string& mode, const std::string& rate, int steps) {
    return "kind = \"path\"\nmode = \"" + mode + "\"\nrelax_steps = 0\n[[segment]]\nvelocity_gradient = [[-" +
           rate + ", 0], [0, -" + rate + "]]\nsteps = " + std::to_string(steps) + "\n";
}

TEST(BadInput, PathThatCrushesTheGrains) {
    const Shell shell("crushed");
    shell.write("p.csv", lattice());
    for (const std::string mode : {"reference", "fast"}) {
        shell.write("t.toml", test_of(mode, "100", 1000));  // to a seventh of the area
        expect_bad_input(shell.run("rve test t.toml --packing p.csv -o out.csv"), "element test", "");
    }
    EXPECT_EQ(shell.files(), 2);
}

TEST(BadInput, TimeStepThatNoContactFollows) {
    const Shell shell("time_step");
    shell.write("p.csv", lattice());
    shell.write("t.toml", "time_step = \"1e-3 s\"\n" + test_of("reference", "0.1", 10));
    expect_bad_input(shell.run("rve test t.toml --packing p.csv -o out.csv"), "element test", "time_step");
    EXPECT_EQ(shell.files(), 2);
}

TEST(BadInput, PackingOfTooFewGrains) {
    const Shell shell("few");
    shell.write("t.toml", path_test);
    shell.write("one.csv", std::string(header) + "0,0.05,0.05,0.01\n");
    shell.write("two.csv", std::string(header) + "0,0.05,0.05,0.01\n1,0.02,0.05,0.01\n");
    expect_bad_input(shell.run("rve test t.toml --packing one.csv -o out.csv"), "one.csv", "1 grain (");
    expect_bad_input(shell.run("rve bench --packing two.csv"), "two.csv", "2 grains");
    shell.write("s.toml", "[grains]\npacking = \"two.csv\"\n");
    expect_bad_input(shell.run("run s.toml -o out"), "two.csv", "2 grains");
}

TEST(BadInput, PressureThatGrainsDoNotBear) {
    const Shell shell("pressed");
    shell.write("r.toml", "pressure = \"10 MPa\"\n[grains]\ncount = 60\n");
    expect_bad_input(shell.run("rve prepare r.toml -o p.h5"), "r.toml:1", "bear 3000 kPa");
    shell.write("s.toml", "[ground]\nsurcharge = \"5 MPa\"\n");
    expect_bad_input(shell.run("run s.toml -o out"), "s.toml:2", "bear 3000 kPa");
    shell.write("c.toml", "[grains]\nconsolidation_pressure = \"5 MPa\"\n");
    expect_bad_input(shell.run("rve prepare c.toml -o p.h5"), "c.toml:2", "bear 3000 kPa");
    EXPECT_EQ(shell.files(), 3);
}

TEST(BadInput, GrainsThatRingOnNameTheirDamping) {
    const Shell shell("ringing");
    shell.write("s.toml", "[grains]\ndamping = 0\n");
    expect_bad_input(shell.run("run s.toml -o out"), "s.toml:2", "grains.damping");
    shell.write("r.toml", "[grains]\nradius_min = \"0.01 mm\"\n");
    expect_bad_input(shell.run("rve prepare r.toml -o p.h5"), "r.toml:2", "grains.radius_min");
}

TEST(BadInput, TruncatedOrForeignHdf5) {
    const Shell shell("truncated");
    shell.write("t.toml", path_test);
    shell.write("p.h5", std::string("\x89HDF\r\n\x1a\n", 8) + std::string(50, '\0'));
    expect_bad_input(shell.run("rve test t.toml --packing p.h5 -o out.csv"), "p.h5", "");
    expect_bad_input(shell.run("info p.h5"), "p.h5", "");
    EXPECT_EQ(shell.files(), 2);
}

TEST(BadInput, ArgumentsThatDoNotExist) {
    const Shell shell("arguments");
    for (const char* arguments :
         {"rev test", "rve tets", "rve bench --step 3", "", "rve", "rve test", "keys scenes"}) {
        const auto outcome = shell.run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_NE(shell.run("rve tets").err.find("did you mean \"test\"?"), std::string::npos);
    EXPECT_NE(shell.run("rve bench --stesp 3").err.find("did you mean \"--steps\"?"), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::app
