#include "tests/unit/app/bad_input.hpp"

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
pull_to = 0.002
ramp = 0.001
[ground]
law = "mohr_coulomb"
)";
constexpr const char* kTable =
    "scene = \"s.toml\"\n[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [1, 1.5]\n";

class Sweep : public testing::Test {
  protected:
    Sweep() {
        shell_.write("s.toml", kScene);
        shell_.write("t.toml", kTable);
    }
    // Two lines in all: the head, and of every row "finished".
    void expect_table_of(const std::string& folder, int finished) const {
        const std::string csv = shell_.read(folder + "/table.csv");
        int found = 0;
        for (std::size_t at = 0; (at = csv.find(",finished\n", at)) != std::string::npos; ++at) ++found;
        EXPECT_EQ(found, finished) << csv;
        EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << csv;
    }
    const Shell shell_{"sweep"};
};

TEST_F(Sweep, RunsItsRowsAndAgainMakesNothing) {
    const auto first = shell_.run("sweep t.toml -o out --jobs 2");
    EXPECT_EQ(first.exit_code, 0) << first.err;
    expect_table_of("out", 2);
    EXPECT_TRUE(shell_.exists("out/index.html"));
    EXPECT_TRUE(shell_.exists("out/rows/embedment_ratio=1.5/1/load.csv"));
    EXPECT_NE(first.err.find("embedment_ratio=1.5/1: finished"), std::string::npos) << first.err;
    const std::string table = shell_.read("out/table.csv");
    const auto again = shell_.run("sweep t.toml -o out --resume");
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(again.err, "");
    EXPECT_EQ(shell_.read("out/table.csv"), table);
}

TEST_F(Sweep, AFailedRowIsToldAndTheOthersFinish) {
    std::filesystem::create_directories(shell_.path("out/rows/embedment_ratio=1/1"));
    shell_.write("out/rows/embedment_ratio=1/1/run.h5", "not ours");  // the run will not write over it
    const auto outcome = shell_.run("sweep t.toml -o out");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("embedment_ratio=1/1: failed: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("go on with: sandgraph sweep t.toml -o out --resume"), std::string::npos);
    expect_table_of("out", 1);
    std::filesystem::remove(shell_.path("out/rows/embedment_ratio=1/1/run.h5"));
    EXPECT_EQ(shell_.run("sweep t.toml -o out").exit_code, 0);
    expect_table_of("out", 2);
}

TEST_F(Sweep, ItsJobArrayRunsTaskByTaskAndCollects) {
    ASSERT_EQ(shell_.run("sweep t.toml -o out --slurm").exit_code, 0);
    EXPECT_NE(shell_.read("out/sweep.sbatch").find("#SBATCH --array=1-2\n"), std::string::npos);
    EXPECT_FALSE(shell_.exists("out/rows"));
    for (const char* task : {"1", "2"}) {
        const std::string command = "cd / && SLURM_ARRAY_TASK_ID=" + std::string(task) + " bash '" +
                                    shell_.path("out/sweep.sbatch") + "' 2>/dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0) << task;
    }
    EXPECT_FALSE(shell_.exists("out/table.csv"));
    EXPECT_EQ(std::system(("sh '" + shell_.path("out/collect.sh") + "' >/dev/null").c_str()), 0);
    expect_table_of("out", 2);
}

// Before its time is over Slurm signals the shell; `scontrol` here is a program of ours that says so.
TEST_F(Sweep, ATaskThatIsStoppedIsQueuedAgain) {
    std::string slow = kScene;
    slow.replace(slow.find("0.002"), 5, "0.3");
    shell_.write("s.toml", slow);
    ASSERT_EQ(shell_.run("sweep t.toml -o out --slurm").exit_code, 0);
    shell_.write("scontrol", "#!/bin/sh\necho \"$@\" >> '" + shell_.path("asked") + "'\n");
    const std::string command =
        "chmod +x '" + shell_.path("scontrol") + "'; PATH='" + shell_.path("") +
        "':$PATH SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=1 timeout --foreground -s TERM 0.5 bash '" +
        shell_.path("out/sweep.sbatch") + "' 2>/dev/null";
    EXPECT_NE(std::system(command.c_str()), 0);
    for (int k = 0; k < 500 && !shell_.exists("asked"); ++k) usleep(10'000);
    EXPECT_EQ(shell_.read("asked"), "requeue 7_1\n");
}

TEST_F(Sweep, BadInputStartsNothing) {
    shell_.write("zip.toml", std::string("combine = \"zip\"\n") + kTable +
                                 "[[axis]]\nkey = \"anchor.width\"\nvalues = [\"1 m\"]\n");
    expect_bad_input(shell_.run("sweep zip.toml -o out"), "zip.toml:6", "in step");
    shell_.write("two.toml", std::string(kTable) + "[set]\nanchor.embedment_ration = 3\n");
    expect_bad_input(shell_.run("sweep two.toml -o out"), "two.toml:6", "unknown key");
    expect_bad_input(shell_.run("sweep s.toml -o out"), "s.toml:2", "this is a scene, not a sweep");
    expect_bad_input(shell_.run("run t.toml -o out"), "t.toml:1", "this is a sweep, not a scene");
    expect_bad_input(shell_.run("sweep t.toml -o out --task 3"), "--task", "3");
    EXPECT_FALSE(shell_.exists("out"));
}

// A million points a run, 1 GB: each fits, a hundred do not.
TEST_F(Sweep, JobsBeyondTheMemoryAreRefused) {
    std::string values;
    for (int k = 0; k < 100; ++k) values += fmt::format("{}{}", k ? ", " : "", 0.1 + 0.001 * k);
    shell_.write("big.toml", "scene = \"s.toml\"\n[[axis]]\nkey = \"anchor.pull_to\"\nvalues = [" + values +
                                 "]\n[set]\ndomain.width = \"100 m\"\ndomain.depth = \"25 m\"\n"
                                 "domain.cell = \"0.05 m\"\n");
    expect_bad_input(shell_.run("sweep big.toml -o out --jobs 100"), "--jobs", "100");
    EXPECT_FALSE(shell_.exists("out"));
}

TEST_F(Sweep, KeysAreListed) {
    const auto outcome = shell_.run("keys sweep");
    EXPECT_EQ(outcome.exit_code, 0);
    for (const char* key : {"scene = ", "samples = 1", "combine = \"product\"", "axis = "})
        EXPECT_NE(outcome.out.find(key), std::string::npos) << key;
}

}  // namespace
}  // namespace sandgraph::app
