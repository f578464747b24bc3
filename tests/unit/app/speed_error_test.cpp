#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/subprocess.hpp"

namespace sandgraph::app {
namespace {

constexpr const char* kScene = R"(
[domain]
width = "2 m"
depth = "3 m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.005
ramp = 0.002
[grains]
count = 60
[output]
load_every = 0.001
frames = [0, 0.005]
)";

double number(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\":");
    return at == std::string::npos ? NAN : std::stod(json.substr(at + key.size() + 3));
}

class SpeedAndError : public testing::Test {
  protected:
    SpeedAndError() : shell_("speed_error") {
        setenv("SANDGRAPH_CACHE", shell_.path("cache").c_str(), 1);
        shell_.write("scene.toml", kScene);
    }
    ~SpeedAndError() override { unsetenv("SANDGRAPH_CACHE"); }
    Shell shell_;
};

TEST_F(SpeedAndError, ParetoRunsFullFidelityTheThresholdsAndTheSurrogateAlone) {
    const std::string command = "pareto scene.toml -o study --thresholds 0,0.002:0.01";
    const auto outcome = shell_.run(command);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(shell_.exists("study/pareto.png") || outcome.out.find("no picture") != std::string::npos);
    std::istringstream csv(shell_.read("study/pareto.csv"));
    std::string line, names;
    std::vector<std::string> labels;
    for (std::getline(csv, names); std::getline(csv, line);) labels.push_back(line.substr(0, line.find(',')));
    EXPECT_EQ(labels, (std::vector<std::string>{"full", "0", "0.002:0.01", "surrogate"}));

    // What is finished is not run again.
    EXPECT_EQ(shell_.run(command).out.find("---"), std::string::npos);

    // Full fidelity against itself, and against a gate that hands over everything at once: no error at all.
    for (const char* other : {"full", "0"}) {
        const auto same = shell_.run(std::string("compare study/full study/") + other + " --json");
        ASSERT_EQ(same.exit_code, 0) << same.err;
        EXPECT_EQ(same.err, "");
        for (const char* error : {"peak_error", "curve_error", "displacement_error", "stress_error"})
            EXPECT_LT(number(same.out, error), 1e-12) << other << ' ' << error;
    }
    const std::string summary = shell_.read("study/0/summary.json"), key = "\"threads\": ";
    shell_.write("study/0/summary.json", std::string(summary).insert(summary.find(key) + key.size(), 1, '9'));
    const auto unlike = shell_.run("compare study/full study/0");
    EXPECT_NE(unlike.err.find("not like for like"), std::string::npos) << unlike.err;

    const auto far = shell_.run("compare study/full study/surrogate --json");
    EXPECT_GT(number(far.out, "stress_error"), 0);
    EXPECT_EQ(number(far.out, "dem_fraction_final"), 0);
}

// Not that of the last audit, nor that of the start, where nothing has been off yet.
TEST_F(SpeedAndError, ARunThatStopsEarlyTellsTheErrorOfItsEnd) {
    ASSERT_EQ(shell_
                  .run("run scene.toml -o part --mode screening --until 0.003 --set gate.active=false "
                       "--set audit.share=0.3 --set audit.every=0.1")
                  .exit_code,
              0);
    const std::string summary = shell_.read("part/summary.json");
    EXPECT_GT(number(summary, "stress_error_mean"), 1e-3) << summary;
    EXPECT_NE(summary.find("\"kinetic_to_strain_energy_max\": null"), std::string::npos) << summary;
}

TEST_F(SpeedAndError, CompareRefusesWhatIsNoFinishedRun) {
    const auto outcome = shell_.run("compare nothing nowhere");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("no run"), std::string::npos);
    ASSERT_EQ(shell_.run("run scene.toml -o part --until 0.002").exit_code, 0);
    std::filesystem::remove(shell_.path("part/summary.json"));  // as after a kill
    const auto unfinished = shell_.run("compare part part");
    EXPECT_EQ(unfinished.exit_code, 2);
    EXPECT_NE(unfinished.err.find("not ended"), std::string::npos) << unfinished.err;
    shell_.write("part/summary.json", "{");
    EXPECT_EQ(shell_.run("compare part part").exit_code, 2);
    EXPECT_EQ(shell_.run("pareto nothing.toml -o study").exit_code, 2);
    EXPECT_FALSE(shell_.exists("study"));
}

}  // namespace
}  // namespace sandgraph::app
