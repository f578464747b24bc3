#include <sys/resource.h>

#include <fmt/format.h>

#include "tests/restart/interrupted_run.hpp"

// Several ranks as users start them: mpirun and the program of the preset mpi. What ranks do together is
// tested without MPI in tests/unit/ranks.
namespace sandgraph::mpi {
namespace {

namespace fs = std::filesystem;
using restart::text_of;

constexpr const char* kRankName = "OMPI_COMM_WORLD_RANK=";

class Ranks : public restart::InterruptedRun {
  protected:
    void SetUp() override {
        restart::InterruptedRun::SetUp();
        setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1), setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    }
    fs::path log() const { return folder_ / "log"; }

    // `told`: what mpirun itself says of a rank's end is left out of the log, or not.
    pid_t start_on(int ranks, const std::string& name, const std::vector<std::string>& more = {},
                   bool told = false) const {
        std::vector<std::string> words = {"/usr/bin/env", "mpirun"};
        if (!told) words.push_back("-q");
        // A write past the size limit fails, as on a full disk, and sends no signal.
        for (const std::string& word :
             {std::string("--oversubscribe"), std::string("--bind-to"), std::string("none"),
              std::string("-n"), std::to_string(ranks), std::string("sh"), std::string("-c"),
              std::string("trap '' XFSZ; exec \"$@\""), std::string("sh"), sandgraph::test::program(),
              std::string("run"), (folder_ / "scene.toml").string(), std::string("-o"), out(name).string()})
            words.push_back(word);
        words.insert(words.end(), more.begin(), more.end());
        return support::start_program(std::move(words), log());
    }
    int run_on(int ranks, const std::string& name, const std::vector<std::string>& more = {}) const {
        return finish(start_on(ranks, name, more));
    }
    void wait_for_checkpoint(pid_t mpirun, const std::string& name) const {
        while (support::program_runs(mpirun) && !fs::exists(out(name) / "checkpoint.h5"))
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    // The process of a rank, found by what mpirun has written into its environment.
    static pid_t process_of(int rank, pid_t mpirun) {
        std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", mpirun));
        for (pid_t pid = 0; children >> pid;)
            if (text_of(fmt::format("/proc/{}/environ", pid)).find(fmt::format("{}{}", kRankName, rank)) !=
                std::string::npos)
                return pid;
        return -1;
    }
    void add_to_scene(const std::string& text) const {
        std::ofstream(folder_ / "scene.toml", std::ios::app) << text;
    }
};

TEST_F(Ranks, ComeToTheBitsOfOneProcess) {
    ASSERT_EQ(run("one"), 0);
    for (const int ranks : {1, 2, 3, 4})
        for (const int threads : {1, 2}) {
            const std::string name = fmt::format("r{}t{}", ranks, threads);
            ASSERT_EQ(run_on(ranks, name, {"--threads", std::to_string(threads)}), 0) << text_of(log());
            expect_same("one", name);
            expect_same_history("one", name);
            fs::remove_all(out(name));
        }
}

TEST_F(Ranks, ComeToTheBitsOfOneProcessInScreening) {
    add_to_scene("[gate]\nstrain = 1e-4\nflow = 0.002\n[audit]\nshare = 0.2\n");
    const std::vector<std::string> screening = {"--mode", "screening", "--threads", "1"};
    ASSERT_EQ(run("one", screening), 0);
    for (const int ranks : {2, 3}) {
        const std::string name = fmt::format("r{}", ranks);
        ASSERT_EQ(run_on(ranks, name, screening), 0) << text_of(log());
        EXPECT_EQ(text_of(out("one") / "load.csv"), text_of(out(name) / "load.csv"));
        EXPECT_EQ(text_of(out("one") / "regions.csv"), text_of(out(name) / "regions.csv"));
        const auto first = io::read_history(out("one") / "history.h5"),
                   second = io::read_history(out(name) / "history.h5");
        ASSERT_EQ(first.rows.size(), second.rows.size());
        for (std::size_t k = 0; k < first.rows.size(); ++k)
            EXPECT_EQ(first.rows[k].stress, second.rows[k].stress);
    }
}

TEST_F(Ranks, ThatAreStoppedGoOnInAnyNumber) {
    ASSERT_EQ(run("one"), 0);
    const pid_t pid = start_on(3, "stopped", {"--threads", "1"});
    wait_for_checkpoint(pid, "stopped");
    kill(pid, SIGUSR1);  // mpirun hands it on
    EXPECT_EQ(finish(pid), 3) << text_of(log());
    ASSERT_EQ(run_on(2, "stopped", {"--threads", "1", "--until", "0.02", "--resume"}), 0) << text_of(log());
    ASSERT_EQ(run("stopped", {"--resume"}), 0);  // and in one process
    expect_same("one", "stopped");
    expect_same_history("one", "stopped");
}

TEST_F(Ranks, OfWhichOneDiesEndWithAMessageAndGoOn) {
    ASSERT_EQ(run("one"), 0);
    const pid_t pid = start_on(3, "killed", {"--threads", "1"}, true);
    wait_for_checkpoint(pid, "killed");
    kill(process_of(2, pid), SIGKILL);
    EXPECT_NE(finish(pid), 0);
    EXPECT_NE(text_of(log()).find("rank 2"), std::string::npos) << text_of(log());
    ASSERT_EQ(run_on(4, "killed", {"--threads", "1", "--resume"}), 0) << text_of(log());
    expect_same("one", "killed");
    expect_same_history("one", "killed");
}

// Rank 0 writes, the others need no disk.
TEST_F(Ranks, OfWhichOneHasAFullDiskEndWithAMessageAndGoOn) {
    ASSERT_EQ(run("one"), 0);
    const pid_t pid = start_on(2, "full", {"--threads", "1"});
    wait_for_checkpoint(pid, "full");
    const rlimit small{10'000, 10'000};
    ASSERT_EQ(prlimit(process_of(0, pid), RLIMIT_FSIZE, &small, nullptr), 0);
    EXPECT_EQ(finish(pid), 1);
    EXPECT_NE(text_of(log()).find("--resume"), std::string::npos) << text_of(log());
    ASSERT_EQ(run_on(2, "full", {"--threads", "1", "--resume"}), 0) << text_of(log());
    expect_same("one", "full");
}

TEST_F(Ranks, BeyondThePointsAreRefusedInOneLine) {
    std::ofstream(folder_ / "scene.toml") << "[domain]\nwidth = \"1 m\"\ndepth = \"2 m\"\ncell = \"1 m\"\n"
                                             "[anchor]\npresent = false\n[mpm]\nend_time = \"1 ms\"\n";
    EXPECT_EQ(run_on(3, "none"), 2);
    const std::string text = text_of(log());
    EXPECT_NE(text.find("3 ranks for 2 material points"), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_FALSE(fs::exists(out("none")));
}

TEST_F(Ranks, RefuseABadSceneOnce) {
    add_to_scene("[grains]\nnonsense = 1\n");
    EXPECT_EQ(run_on(3, "none"), 2);
    const std::string text = text_of(log());
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST_F(Ranks, AreForRunsAlone) {
    std::vector<std::string> words = {
        "/usr/bin/env", "mpirun", "-q", "--oversubscribe", "-n", "2", sandgraph::test::program(), "keys"};
    EXPECT_EQ(finish(support::start_program(std::move(words), log())), 2);
}

}  // namespace
}  // namespace sandgraph::mpi
