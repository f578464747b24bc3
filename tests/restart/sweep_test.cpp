#include "tests/restart/interrupted_run.hpp"

namespace sandgraph::restart {
namespace {

// Two by two pulls of a second on Mohr-Coulomb ground.
constexpr const char* kGround = R"(
[domain]
width = "3 m"
depth = "4 m"
cell = "0.2 m"
[anchor]
embedment_ratio = 1
thickness = "0.2 m"
pull_to = 0.03
[ground]
law = "mohr_coulomb"
[output]
checkpoint_every = "0.05 s"
)";
constexpr const char* kTable = R"(
scene = "ground.toml"
[[axis]]
key = "anchor.embedment_ratio"
values = [1, 2]
[[axis]]
key = "continuum.friction_angle"
values = ["25 deg", "35 deg"]
)";

class InterruptedSweep : public InterruptedRun {
  protected:
    void SetUp() override {
        InterruptedRun::SetUp();
        std::ofstream(folder_ / "ground.toml") << kGround;
        std::ofstream(folder_ / "table.toml") << kTable;
    }
    pid_t sweep(const std::string& name) const {
        return support::start_program({sandgraph::test::program(), "sweep", (folder_ / "table.toml").string(),
                                       "-o", out(name).string(), "--jobs", "2"},
                                      folder_ / (name + ".log"));
    }
    // A child of the sweep; 0: it has none just now.
    static pid_t child_of(pid_t parent) {
        std::ifstream in("/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) + "/children");
        pid_t child = 0;
        in >> child;
        return child;
    }
    static void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }
    bool has_checkpoint(const std::string& name) const {
        for (const auto& entry : fs::recursive_directory_iterator(out(name)))
            if (entry.path().filename() == "checkpoint.h5") return true;
        return false;
    }
    void wait_for_checkpoint(const std::string& name, pid_t pid) const {
        while (support::program_runs(pid) && !(fs::exists(out(name)) && has_checkpoint(name)))
            wait_a_little();
    }
    // table.csv without what a run has cost.
    std::string table_of(const std::string& name) const {
        std::istringstream in(text_of(out(name) / "table.csv"));
        std::string text, line;
        std::getline(in, line);
        const auto cost = std::count(line.begin(), line.begin() + long(line.find("cpu_s")), ',');
        for (text = line; std::getline(in, line); text += "\n") {
            std::istringstream cells(line);
            std::string cell;
            for (long k = 0; std::getline(cells, cell, ','); ++k) text += k == cost ? "," : cell + ",";
        }
        return text;
    }
};

TEST_F(InterruptedSweep, GoesOnAfterAKilledChildAndAStopWithTheSameTable) {
    ASSERT_EQ(finish(sweep("whole")), 0) << text_of(folder_ / "whole.log");
    const std::string whole = table_of("whole");
    EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 4) << whole;

    const pid_t killed = sweep("broken");
    wait_for_checkpoint("broken", killed);
    const pid_t child = child_of(killed);
    ASSERT_GT(child, 0);
    kill(child, SIGKILL);
    EXPECT_EQ(finish(killed), 1);
    const std::string told = text_of(folder_ / "broken.log");
    EXPECT_NE(told.find("failed: ended by signal 9"), std::string::npos) << told;
    EXPECT_NE(table_of("broken"), whole);
    EXPECT_NE(table_of("broken").find("failed"), std::string::npos);

    fs::remove_all(out("broken") / "rows" / "embedment_ratio=2_friction_angle=25deg");
    const pid_t stopped = sweep("broken");
    while (support::program_runs(stopped) && child_of(stopped) == 0) wait_a_little();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    kill(stopped, SIGINT);
    EXPECT_EQ(finish(stopped), 3) << text_of(folder_ / "broken.log");
    EXPECT_NE(text_of(folder_ / "broken.log").find("go on with: "), std::string::npos);

    EXPECT_EQ(finish(sweep("broken")), 0) << text_of(folder_ / "broken.log");
    EXPECT_EQ(table_of("broken"), whole);
}

}  // namespace
}  // namespace sandgraph::restart
