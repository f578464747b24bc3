#include "tests/restart/interrupted_run.hpp"
#include "support/paths.hpp"

namespace sandgraph::restart {
namespace {

TEST_F(InterruptedRun, ResumesToTheSameBits) {
    ASSERT_EQ(run("whole"), 0);
    EXPECT_TRUE(fs::exists(out("whole") / "summary.json"));

    EXPECT_EQ(stop("asked", SIGINT, 10), 3);
    EXPECT_FALSE(fs::exists(out("asked") / "summary.json"));
    ASSERT_EQ(run("asked", {"--resume", "--threads", "1"}), 0);
    expect_same("whole", "asked");
    expect_same_history("whole", "asked");

    EXPECT_EQ(stop("killed", SIGKILL, 15), 128 + SIGKILL);
    ASSERT_EQ(run("killed", {"--resume"}), 0);
    expect_same("whole", "killed");
    expect_same_history("whole", "killed");
}

// Surrogate states, recorded paths, replays, shadows, audits and fading jumps all go through the checkpoint.
TEST_F(InterruptedRun, OfScreeningResumesToTheSameBits) {
    const std::vector<std::string> screening = {
        "--mode", "screening",         "--set", "output.history=false",
        "--set",  "gate.strain=0.001", "--set", "audit.share=0.1"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), screening.begin(), screening.end());
        return more;
    };
    ASSERT_EQ(run("whole", screening), 0);
    EXPECT_EQ(stop("killed", SIGKILL, 10, screening), 128 + SIGKILL);
    ASSERT_EQ(run("killed", with({"--resume", "--threads", "1"})), 0);
    expect_same_ground("whole", "killed");
    const auto audited = [&](const std::string& name) {
        const std::string all = text_of(out(name) / "summary.json");
        return all.substr(all.find("\"audit\""),
                          all.find("}", all.find("\"audit\"")) - all.find("\"audit\""));
    };
    EXPECT_EQ(audited("whole"), audited("killed"));
    EXPECT_EQ(text_of(out("whole") / "summary.json").find("\"surrogate_updates\": 0,"), std::string::npos);
}

TEST_F(InterruptedRun, StopsWhereAskedAndGoesOn) {
    ASSERT_EQ(run("whole"), 0);
    ASSERT_EQ(run("part", {"--until", "0.015"}), 0);
    ASSERT_EQ(run("part", {"--resume"}), 0);
    expect_same("whole", "part");
}

// The restart files go one after another: a kill in between leaves some of them.
TEST_F(InterruptedRun, KilledWhileItClearsUpIsResumedOrHasEnded) {
    ASSERT_EQ(run("whole"), 0);
    EXPECT_EQ(stop("killed", SIGKILL, 15), 128 + SIGKILL);
    fs::rename(out("killed") / "checkpoint.h5", out("killed") / "checkpoint.h5.prev");
    ASSERT_EQ(run("killed", {"--resume"}), 0);
    expect_same("whole", "killed");
    expect_same_history("whole", "killed");

    std::ofstream(out("whole") / "history.part") << "rows";
    EXPECT_EQ(run("whole", {"--resume"}), 0);
    expect_same_history("killed", "whole");
    EXPECT_TRUE(fs::exists(out("whole") / "summary.json"));
}

// No step is done yet: what is kept is the packings.
TEST_F(InterruptedRun, StopsWhilePackingsAreMade) {
    const fs::path cache = folder_ / "cache";
    const pid_t pid = start("early", {"--set", "grains.count=400"});
    while (support::program_runs(pid) && (!fs::exists(cache) || fs::is_empty(cache)))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(pid, SIGTERM);
    EXPECT_EQ(finish(pid), 3);
    EXPECT_FALSE(fs::exists(out("early")));
    EXPECT_FALSE(fs::is_empty(cache));
    for (const auto& entry : fs::directory_iterator(cache)) EXPECT_NE(entry.path().extension(), ".tmp");
    EXPECT_EQ(run("early", {"--set", "grains.count=400", "--until", "0.001"}), 0);
}

// Scripts take summary.json for the end of a run.
TEST_F(InterruptedRun, KilledOnItsWayHasNoSummaryOfAnEarlierEnd) {
    ASSERT_EQ(run("part", {"--until", "0.002"}), 0);
    ASSERT_TRUE(fs::exists(out("part") / "summary.json"));
    EXPECT_EQ(stop("part", SIGKILL, 4, {"--resume"}), 128 + SIGKILL);
    EXPECT_FALSE(fs::exists(out("part") / "summary.json"));
}

// A closed terminal: the shell and the kernel both say so, one after the other.
TEST_F(InterruptedRun, AHangUpStopsLikeATermination) {
    EXPECT_EQ(stop("hung up", SIGHUP, 5), 3);
    EXPECT_TRUE(fs::exists(out("hung up") / "checkpoint.h5"));
    ASSERT_EQ(run("hung up", {"--resume"}), 0);
}

int shell(const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// Nothing secondary may end a run: progress into a full disk, a reader that has gone.
TEST_F(InterruptedRun, OutputThatNobodyCanReadDoesNotEndIt) {
    const std::string words = sandgraph::test::program() + " run '" + (folder_ / "scene.toml").string() +
                              "' --until 0.002 -o '" + folder_.string() + "/";
    EXPECT_EQ(shell(words + "full' >/dev/full 2>/dev/full"), 0);
    EXPECT_EQ(shell("{ " + words + "pipe' 2>&1; echo $? >'" + folder_.string() + "/code'; } | true"), 0);
    EXPECT_EQ(text_of(folder_ / "code"), "0\n");
    for (const char* name : {"full", "pipe"}) EXPECT_TRUE(fs::exists(out(name) / "summary.json")) << name;
}

}  // namespace
}  // namespace sandgraph::restart
