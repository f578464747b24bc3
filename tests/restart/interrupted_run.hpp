#pragma once
#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "io/history_file.hpp"
#include "io/packing_file.hpp"
#include "io/run_record.hpp"
#include "support/paths.hpp"
#include "tests/support/program.hpp"

namespace sandgraph::restart {

namespace fs = std::filesystem;

// A pull of some seconds: 100 grains a point, 0.25 m cells.
inline constexpr const char* kScene = R"(
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
checkpoint_every = "0.2 s"
[[region]]
name = "above"
x = [0, 0.5]
y = [0, 1]
packings = [0, 0.0004, 0.011, 0.025]
)";

inline std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

// Every file of a folder by its name.
inline std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) all[fs::relative(entry, folder).string()] = text_of(entry);
    return all;
}

// No number is the same as no number.
inline bool same_bits(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

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
        std::vector<std::string> words = {sandgraph::test::program(), "run",
                                          (folder_ / "scene.toml").string(), "-o", out(name).string()};
        words.insert(words.end(), more.begin(), more.end());
        return support::start_program(std::move(words), "/dev/null");
    }
    static int finish(pid_t pid) { return support::finish_program(pid); }
    int run(const std::string& name, std::vector<std::string> more = {}) const {
        return finish(start(name, std::move(more)));
    }

    // Signals the run once it has a checkpoint and `rows` lines in its load curve.
    int stop(const std::string& name, int signal, std::size_t rows,
             std::vector<std::string> more = {}) const {
        const pid_t pid = start(name, std::move(more));
        while (support::program_runs(pid)) {
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
        for (const char* packing : {"above_0000.h5", "above_0000.4.h5", "above_0011.h5", "above_0025.h5"}) {
            const auto p = io::read_packing(out(a) / "packings" / packing).packing,
                       q = io::read_packing(out(b) / "packings" / packing).packing;
            EXPECT_EQ(p.x, q.x);
            EXPECT_EQ(p.H, q.H);
        }
    }
    void expect_same_ground(const std::string& a, const std::string& b) const {
        EXPECT_EQ(text_of(out(a) / "load.csv"), text_of(out(b) / "load.csv"));
        EXPECT_EQ(text_of(out(a) / "regions.csv"), text_of(out(b) / "regions.csv"));
        const auto first = io::read_run(out(a) / "run.h5"), second = io::read_run(out(b) / "run.h5");
        ASSERT_EQ(first.frames, 4u);
        ASSERT_EQ(second.frames, 4u);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto f = io::read_run_frame(out(a) / "run.h5", k),
                       g = io::read_run_frame(out(b) / "run.h5", k);
            EXPECT_EQ(f.x, g.x);
            EXPECT_EQ(f.y, g.y);
            for (std::size_t n = 0; n < f.fields.size(); ++n)
                EXPECT_TRUE(std::ranges::equal(f.fields[n].values, g.fields[n].values, same_bits))
                    << f.fields[n].name;
        }
    }
    void expect_same_history(const std::string& a, const std::string& b) const {
        const auto first = io::read_history(out(a) / "history.h5"),
                   second = io::read_history(out(b) / "history.h5");
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

}  // namespace sandgraph::restart
