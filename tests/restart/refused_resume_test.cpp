#include <thread>

#include "io/content.hpp"
#include "io/h5_handle.hpp"
#include "tests/restart/interrupted_run.hpp"

namespace sandgraph::restart {
namespace {

// Whole and sealed, of this scene, and yet no state of it: as another version of the program would leave it.
TEST_F(InterruptedRun, RefusesACheckpointWhoseStateIsAnothers) {
    EXPECT_EQ(stop("part", SIGINT, 3), 3);
    const fs::path file = out("part") / "checkpoint.h5";
    {
        const io::h5::Handle whole(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose),
            data(H5Dopen2(whole.get(), "state/rve", H5P_DEFAULT), H5Dclose),
            space(H5Dget_space(data.get()), H5Sclose);
        const std::vector<std::uint8_t> other(
            static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())), 0xff);
        ASSERT_GE(H5Dwrite(data.get(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, other.data()), 0);
    }
    io::seal(file);
    const auto before = contents(out("part"));
    EXPECT_EQ(run("part", {"--resume"}), 2);
    EXPECT_EQ(contents(out("part")), before);
}

TEST_F(InterruptedRun, RefusesAFolderThatCannotBe) {
    std::ofstream(out("file")) << "in the way";
    EXPECT_EQ(run("file"), 2);
    EXPECT_EQ(run("file/below"), 2);
    EXPECT_EQ(text_of(out("file")), "in the way");
}

TEST_F(InterruptedRun, WritesOverNoForeignFile) {
    for (const char* name : {"load.csv", "summary.json", "run.h5"}) {
        const fs::path folder = out(std::string("with_") + name);
        fs::create_directories(folder);
        std::ofstream(folder / name) << "x,y\n1,2\n";
        EXPECT_EQ(run("with_" + std::string(name)), 2);
        EXPECT_EQ(text_of(folder / name), "x,y\n1,2\n");
        EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << name;
    }
    ASSERT_EQ(run("mine", {"--until", "0.001"}), 0);
    EXPECT_EQ(run("mine", {"--until", "0.001"}), 0) << "an earlier run's results are replaced";
}

// A second run in the folder of one that is going on is refused, and the first one's results stay its own.
TEST_F(InterruptedRun, OwnsItsFolder) {
    const pid_t first = start("same");
    while (support::program_runs(first) && !fs::exists(out("same") / "load.csv"))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(run("same", {"--set", "grains.seed=7"}), 2);
    EXPECT_EQ(finish(first), 0);
    ASSERT_EQ(run("alone"), 0);
    EXPECT_EQ(text_of(out("same") / "load.csv"), text_of(out("alone") / "load.csv"));
}

// A job may be queued again whatever became of it.
TEST_F(InterruptedRun, ResumesWhereThereIsNothingAndLeavesAFinishedRun) {
    ASSERT_EQ(run("plain"), 0);
    ASSERT_EQ(run("fresh", {"--resume"}), 0);
    EXPECT_EQ(text_of(out("fresh") / "load.csv"), text_of(out("plain") / "load.csv"));
    const auto before = contents(out("fresh"));
    EXPECT_EQ(run("fresh", {"--resume"}), 0);
    EXPECT_EQ(contents(out("fresh")), before);
    EXPECT_EQ(run("fresh", {"--resume", "--set", "grains.seed=2"}), 2) << "finished, but another scene's";
    EXPECT_EQ(contents(out("fresh")), before);
}

TEST_F(InterruptedRun, RefusesToResumeAnotherScene) {
    ASSERT_EQ(run("part", {"--until", "0.002"}), 0);
    const auto before = contents(out("part"));
    EXPECT_EQ(run("part", {"--resume", "--set", "grains.seed=2"}), 2);
    EXPECT_EQ(run("part", {"--resume", "--set", "output.history_points=11"}), 2);
    EXPECT_EQ(run("part", {"--resume", "--set", "region=[]"}), 2);
    EXPECT_EQ(contents(out("part")), before);
}

// The marks of frames change no physics, so they may be others when a run goes on.
TEST_F(InterruptedRun, GoesOnWithOtherFrames) {
    ASSERT_EQ(run("part", {"--until", "0.015"}), 0);
    ASSERT_EQ(run("part", {"--resume", "--set", "output.frames=[0.02]"}), 0);
    const io::RunRecord record = io::read_run(out("part") / "run.h5");
    ASSERT_EQ(record.frames, 3u);  // 0, 0.01, and the new one
    EXPECT_NEAR(io::read_run_frame(out("part") / "run.h5", 2).d_over_B, 0.02, 1e-3);
}

TEST_F(InterruptedRun, CountsTheTimeOfAllItsParts) {
    const auto seconds = [&] {
        double sum = 0;
        for (const auto& [phase, part] : io::read_run(out("part") / "run.h5").timing) sum += part;
        return sum;
    };
    ASSERT_EQ(run("part", {"--until", "0.029"}), 0);
    const double most = seconds();
    ASSERT_EQ(run("part", {"--resume"}), 0);
    EXPECT_GT(seconds(), most);
}

}  // namespace
}  // namespace sandgraph::restart
