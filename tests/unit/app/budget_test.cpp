#include "tests/unit/app/bad_input.hpp"

// The budget of a load, as a user meets it, on ground that costs next to nothing.
namespace sandgraph::app {
namespace {

constexpr const char* kScene = R"(
[domain]
width = "3 m"
depth = "3 m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.03
ramp = 0.001
[ground]
law = "mohr_coulomb"
)";

class Budget : public testing::Test {
  protected:
    Budget() { shell_.write("s.toml", kScene); }
    const Shell shell_{"budget"};
};

TEST_F(Budget, TellsTheLoadWithItsErrorsAndAgainRunsNothing) {
    const auto first = shell_.run("budget s.toml -o out");
    ASSERT_EQ(first.exit_code, 0) << first.err;
    for (const char* run : {"run", "fine", "packing_1", "half_rate"})
        EXPECT_TRUE(shell_.exists(std::string("out/") + run + "/summary.json")) << run;
    EXPECT_FALSE(shell_.exists("out/packing_2/summary.json")) << "closed-form ground has no packings";
    EXPECT_NE(first.out.find("corrected "), std::string::npos) << first.out;
    const std::string json = shell_.read("out/budget.json");
    EXPECT_NE(json.find("\"source\": \"mesh\""), std::string::npos) << json;
    const auto again = shell_.run("budget s.toml -o out");
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(again.out.find("--- "), std::string::npos) << "nothing is run anew: " << again.out;
    EXPECT_EQ(shell_.read("out/budget.json"), json);
}

TEST_F(Budget, IsRefusedOfAGroundWithoutAPlate) {
    shell_.write("s.toml", "[anchor]\npresent = false\n[mpm]\nend_time = \"1 s\"\n[ground]\nlaw = \"elastic\"\n");
    const auto outcome = shell_.run("budget s.toml -o out");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("breakout load of one plate"), std::string::npos) << outcome.err;
    EXPECT_FALSE(shell_.exists("out/run"));
}

constexpr const char* kSand = R"(
[domain]
width = "2 m"
depth = "2.5 m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.003
ramp = 0.001
[grains]
count = 50
[output]
frames = [0]
)";

TEST_F(Budget, RunsOnePackingAfterTheOther) {
    shell_.write("sand.toml", kSand);
    const auto outcome = shell_.run("run sand.toml -o out --samples 2 --threads 1");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string csv = shell_.read("out/samples.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << csv;
    EXPECT_NE(csv.find("\n2,2,no,"), std::string::npos) << csv;  // too short a pull to break out
    EXPECT_NE(shell_.read("out/sample_1/load.csv"), shell_.read("out/sample_2/load.csv"));
    EXPECT_NE(outcome.out.find("0 of 2 packings broke out"), std::string::npos) << outcome.out;
}

TEST_F(Budget, RunsNoSamplesOfGroundWithoutPackings) {
    const auto outcome = shell_.run("run s.toml -o out --samples 2");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("draws no packings by seed"), std::string::npos) << outcome.err;
    EXPECT_EQ(shell_.run("run s.toml --samples 2").exit_code, 2) << "no folder";
}

}  // namespace
}  // namespace sandgraph::app
