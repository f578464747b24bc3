#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "io/h5_handle.hpp"
#include "io/history_file.hpp"
#include "io/packing_file.hpp"
#include "io/run_record.hpp"
#include "io/seal.hpp"
#include "tests/support/program.hpp"

namespace {

namespace fs = std::filesystem;
namespace io = sandgraph::io;

// A pull of some seconds: 100 grains a point, 0.25 m cells.
constexpr const char* kScene = R"(
[domain]
width = "2 m"
depth = "3 m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.03
[grains]
count = 100
[output]
load_every = 0.001
frames = [0, 0.01, 0.02, 0.03]
history = true
history_points = 12
checkpoint_every = "0.05 s"
[[region]]
name = "above"
x = [0, 0.5]
y = [0, 1]
packings = [0, 0.011, 0.025]
)";

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

// No number is the same as no number.
bool same_bits(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

class InterruptedRun : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("sandgraph-restart-" + std::to_string(getpid()));
        fs::create_directories(folder_);
        setenv("SANDGRAPH_CACHE", (folder_ / "cache").c_str(), 1);
        std::ofstream(folder_ / "scene.toml") << kScene;
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path out(const std::string& name) const { return folder_ / name; }

    pid_t start(const std::string& name, std::vector<std::string> more = {}) const {
        std::vector<std::string> words = {SANDGRAPH_BINARY, "run", (folder_ / "scene.toml").string(), "-o",
                                          out(name).string()};
        words.insert(words.end(), more.begin(), more.end());
        return sandgraph::support::start_program(std::move(words), "/dev/null");
    }
    static int finish(pid_t pid) { return sandgraph::support::finish_program(pid); }
    int run(const std::string& name, std::vector<std::string> more = {}) const {
        return finish(start(name, std::move(more)));
    }

    // Signals the run once it has a checkpoint and `rows` lines in its load curve.
    int stop(const std::string& name, int signal, std::size_t rows,
             std::vector<std::string> more = {}) const {
        const pid_t pid = start(name, std::move(more));
        while (sandgraph::support::program_runs(pid)) {
            const std::string load = text_of(out(name) / "load.csv");
            if (fs::exists(out(name) / "checkpoint.h5") &&
                std::count(load.begin(), load.end(), '\n') > long(rows))
                break;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        kill(pid, signal);
        return finish(pid);
    }

    void expect_same(const std::string& a, const std::string& b) const {
        expect_same_ground(a, b);
        for (const char* packing : {"above_0000.h5", "above_0011.h5", "above_0025.h5"}) {
            const auto p = sandgraph::io::read_packing(out(a) / "packings" / packing).packing,
                       q = sandgraph::io::read_packing(out(b) / "packings" / packing).packing;
            EXPECT_EQ(p.x, q.x);
            EXPECT_EQ(p.H, q.H);
        }
    }
    void expect_same_ground(const std::string& a, const std::string& b) const {
        EXPECT_EQ(text_of(out(a) / "load.csv"), text_of(out(b) / "load.csv"));
        EXPECT_EQ(text_of(out(a) / "regions.csv"), text_of(out(b) / "regions.csv"));
        const auto first = sandgraph::io::read_run(out(a) / "run.h5"),
                   second = sandgraph::io::read_run(out(b) / "run.h5");
        ASSERT_EQ(first.frames, 4u);
        ASSERT_EQ(second.frames, 4u);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto f = sandgraph::io::read_run_frame(out(a) / "run.h5", k),
                       g = sandgraph::io::read_run_frame(out(b) / "run.h5", k);
            EXPECT_EQ(f.x, g.x);
            EXPECT_EQ(f.y, g.y);
            for (std::size_t n = 0; n < f.fields.size(); ++n)
                EXPECT_TRUE(std::ranges::equal(f.fields[n].values, g.fields[n].values, same_bits))
                    << f.fields[n].name;
        }
    }
    void expect_same_history(const std::string& a, const std::string& b) const {
        const auto first = sandgraph::io::read_history(out(a) / "history.h5"),
                   second = sandgraph::io::read_history(out(b) / "history.h5");
        EXPECT_FALSE(fs::exists(out(b) / "history.part"));
        ASSERT_EQ(first.histories.size(), 12u);
        ASSERT_EQ(first.begin, second.begin);
        EXPECT_GT(first.rows.size(), 200u);
        for (std::size_t k = 0; k < first.rows.size(); ++k) {
            ASSERT_EQ(first.rows[k].F_inc, second.rows[k].F_inc) << k;
            ASSERT_EQ(first.rows[k].stress, second.rows[k].stress) << k;
            ASSERT_EQ(first.rows[k].dt, second.rows[k].dt) << k;
            ASSERT_EQ(first.rows[k].energy, second.rows[k].energy) << k;
        }
    }
    fs::path folder_;
};

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
    EXPECT_EQ(run("whole", {"--resume"}), 2);
    expect_same_history("killed", "whole");
    EXPECT_TRUE(fs::exists(out("whole") / "summary.json"));
}

// Scripts take summary.json for the end of a run.
TEST_F(InterruptedRun, KilledOnItsWayHasNoSummaryOfAnEarlierEnd) {
    ASSERT_EQ(run("part", {"--until", "0.002"}), 0);
    ASSERT_TRUE(fs::exists(out("part") / "summary.json"));
    EXPECT_EQ(stop("part", SIGKILL, 4, {"--resume"}), 128 + SIGKILL);
    EXPECT_FALSE(fs::exists(out("part") / "summary.json"));
}

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
    const std::string before = text_of(file);
    EXPECT_EQ(run("part", {"--resume"}), 2);
    EXPECT_EQ(text_of(file), before);
}

TEST_F(InterruptedRun, RefusesAFolderThatCannotBe) {
    std::ofstream(out("file")) << "in the way";
    EXPECT_EQ(run("file"), 2);
    EXPECT_EQ(run("file/below"), 2);
    EXPECT_EQ(text_of(out("file")), "in the way");
}

TEST_F(InterruptedRun, RefusesToResumeNothingOrAnotherScene) {
    EXPECT_EQ(run("nothing", {"--resume"}), 2);
    EXPECT_FALSE(fs::exists(out("nothing")));
    ASSERT_EQ(run("part", {"--until", "0.002"}), 0);
    EXPECT_EQ(run("part", {"--resume", "--set", "grains.seed=2"}), 2);
    EXPECT_EQ(run("part", {"--resume", "--set", "output.history_points=11"}), 2);
    EXPECT_EQ(run("part", {"--resume", "--set", "region=[]"}), 2);
}

}  // namespace
