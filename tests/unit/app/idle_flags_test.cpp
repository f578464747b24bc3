#include <gtest/gtest.h>

#include "tests/unit/app/bad_input.hpp"

namespace sandgraph::app {
namespace {

constexpr const char* kTest =
    "kind = \"path\"\nrelax_steps = 0\n[[segment]]\nvelocity_gradient = [[0, 0], [0, 0]]\nsteps = 1\n";
constexpr const char* kPacking = "# {}\n# cell\n# 0.1 0 0 0.1\nid,x,y,r\n0,0.05,0.05,0.01\n";

TEST(Flags, ThatExcludeEachOtherAreRefused) {
    const Shell shell("flags");
    for (const char* arguments :
         {"rve bench --packing p.csv --grains 100", "rve bench --growth --grains 100",
          "rve bench --growth --target all", "rve bench --reference --target all",
          "rve study --quick --seeds 2", "rve table --quick --seeds 5",
          "run s.toml --mode full --set mode=screening", "run s.toml -o a --set output.folder=b"}) {
        const auto outcome = shell.run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(shell.files(), 0);
}

TEST(OutputName, OfAnotherKindIsRefusedAndNothingIsWritten) {
    const Shell shell("names");
    shell.write("t.toml", kTest), shell.write("p.csv", kPacking),
        shell.write("r.toml", "[grains]\ncount = 20\n");
    expect_bad_input(shell.run("rve test t.toml --packing p.csv -o x.png"), "x.png",
                     "not the name of a .csv file");
    expect_bad_input(shell.run("rve prepare r.toml -o x.csv"), "x.csv", "not the name of a .h5 file");
    expect_bad_input(shell.run("rve prepare r.toml -o x.h5 --csv x.txt"), "x.txt",
                     "not the name of a .csv file");
    expect_bad_input(shell.run("measure . --csv x.pdf"), "x.pdf", "not the name of a .csv file");
    EXPECT_EQ(shell.files(), 3);
}

TEST(WrongFile, IsToldByItsKind) {
    const Shell shell("kinds");
    shell.write("t.toml", kTest), shell.write("s.toml", "[anchor]\nwidth = \"1 m\"\n"),
        shell.write("P.CSV", lattice());
    expect_bad_input(shell.run("run t.toml -o out"), "t.toml:1", "an element test, not a scene");
    expect_bad_input(shell.run("rve test s.toml --packing P.CSV"), "s.toml:1",
                     "a scene, not an element test");
    expect_bad_input(shell.run("rve prepare s.toml -o p.h5"), "s.toml:1", "a scene, not a packing recipe");
    EXPECT_EQ(shell.run("rve test t.toml --packing P.CSV -o out.csv").exit_code, 0);
}

TEST(Thresholds, MayBeSeveralWords) {
    const Shell shell("thresholds");
    for (const char* arguments :
         {"none.toml -o out --thresholds 0.01 0.02:0.1", "--thresholds 0.01 0.02 none.toml -o out",
          "none.toml --thresholds 0.01,0.02 0.03 -o out"})
        expect_bad_input(shell.run(std::string("pareto ") + arguments), "none.toml", "cannot be read");
    expect_bad_input(shell.run("pareto none.toml more.toml -o out"), "sandgraph pareto",
                     "unknown argument \"more.toml\"");
    expect_bad_input(shell.run("pareto none.toml 0.01 -o out"), "sandgraph pareto",
                     "unknown argument \"0.01\"");
}

TEST(Thresholds, AreVariedByTheStudyAlone) {
    const Shell shell("varied");
    shell.write("s.toml", "");
    for (const char* set : {"gate.strain=0.01", "gate.active=true", "mode=full", "gate.flow=0"})
        expect_bad_input(shell.run(std::string("pareto s.toml -o out --thresholds 0.01:0.1 --set ") + set),
                         "--set", "the study varies it");
    EXPECT_EQ(shell.files(), 1);
}

// What the keys of an element test change in its packing's material stands on the screen.
TEST(RveTest, TellsOfAnotherMaterialThanThePackings) {
    const Shell shell("material");
    shell.write("r.toml", "pressure = \"10 kPa\"\n[grains]\ncount = 20\nrolling_limit = 0.3\n");
    ASSERT_EQ(shell.run("rve prepare r.toml -o p.h5").exit_code, 0);
    shell.write("t.toml", kTest);
    EXPECT_EQ(shell.run("rve test t.toml --packing p.h5 -o a.csv").err, "");
    shell.write("u.toml", std::string(kTest) + "[grains]\nrolling_limit = 0.1\n");
    const auto told = shell.run("rve test u.toml --packing p.h5 -o a.csv");
    EXPECT_EQ(told.exit_code, 0);
    EXPECT_EQ(told.err, "u.toml: grains.rolling_limit = 0.1 instead of the packing's 0.3\n");
}

TEST(RvePrepare, KeepsTheMaterialOfThePackingItStartsFrom) {
    const Shell shell("again");
    shell.write("r.toml",
                "pressure = \"10 kPa\"\n[grains]\ncount = 20\nrolling_limit = 0.3\nyoung = \"200 MPa\"\n");
    ASSERT_EQ(shell.run("rve prepare r.toml -o p.h5").exit_code, 0);
    shell.write("a.toml", "pressure = \"12 kPa\"\n[grains]\npacking = \"p.h5\"\n");
    const auto again = shell.run("rve prepare a.toml -o a.h5");
    ASSERT_EQ(again.exit_code, 0) << again.err;
    const std::string info = shell.run("info a.h5").out;
    EXPECT_NE(info.find("rolling_limit = 0.3"), std::string::npos) << info;
    EXPECT_NE(info.find("young = 200000000"), std::string::npos) << info;
}

}  // namespace
}  // namespace sandgraph::app
