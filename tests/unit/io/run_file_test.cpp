#include "io/run_file.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "base/error.hpp"
#include "io/checkpoint.hpp"
#include "io/load_columns.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

namespace fs = std::filesystem;
using test::Scratch;

const RunInfo info{"[domain]\nwidth = \"6 m\"\n", "0123abc", "0.1", "deadbeef", "full", 2};

LoadRow row(int k) {
    LoadRow r;
    r.d_over_B = 0.0005 * k;
    r.load = 1e5 * std::sin(0.1 * k) / 3;
    r.dem_steps = 1000.0 * k;
    return r;
}

Frame frame(int k) {
    Frame f{0.1 * k, 0.02 * k, 0, 1 + 0.02 * k, {}, {}, {}};
    Field displacement{"displacement", "m", 2, {}}, porosity{"porosity", "-", 1, {}};
    for (int p = 0; p < 300; ++p) {
        f.x.push_back(0.1 * (p % 20)), f.y.push_back(0.1 * (p / 20));
        displacement.values.insert(displacement.values.end(), {1e-3 * k * p, -1e-4 * p});
        porosity.values.push_back(0.16 + 1e-4 * k);
    }
    f.fields = {displacement, porosity};
    return f;
}

// Ten load rows, then a frame, and so on, from step `from` on.
void advance(RunFile& run, int from, int to) {
    for (int k = from; k < to; ++k) {
        run.append(row(k));
        if (k % 10 == 9) run.append(frame(k / 10));
    }
}

void expect_same_outputs(const fs::path& a, const fs::path& b) {
    EXPECT_EQ(test::contents(a / "load.csv"), test::contents(b / "load.csv"));
    EXPECT_EQ(test::contents(a / "fields.xdmf"), test::contents(b / "fields.xdmf"));
    const RunRecord ra = read_run(a / "run.h5"), rb = read_run(b / "run.h5");
    ASSERT_EQ(ra.load.size(), rb.load.size());
    for (const LoadColumn& c : load_columns())
        for (std::size_t k = 0; k < ra.load.size(); ++k)
            EXPECT_EQ(ra.load[k].*c.member, rb.load[k].*c.member);
    ASSERT_EQ(ra.frames, rb.frames);
    for (std::size_t k = 0; k < ra.frames; ++k) {
        const Frame fa = read_run_frame(a / "run.h5", k), fb = read_run_frame(b / "run.h5", k);
        EXPECT_EQ(fa.d_over_B, fb.d_over_B);
        EXPECT_EQ(fa.x, fb.x);
        EXPECT_EQ(fa.fields.at(0).values, fb.fields.at(0).values);
    }
}

// Through every rewriting of the file.
TEST(RunFile, KeepsTheNamesOfComponentsAndCodes) {
    const Scratch folder;
    RunFile run = RunFile::create(folder.path(), info);
    Frame named = frame(1);
    named.fields = {{"stress", "Pa", 3, std::vector<double>(900, 1), "xx yy xy"},
                    {"mode", "-", 1, std::vector<double>(300, 1), "", "surrogate replay"}};
    run.append(named);
    run.commit();
    const Frame read = read_run_frame(folder / "run.h5", 0);
    EXPECT_EQ(std::ranges::find(read.fields, "stress", &Field::name)->component_names, "xx yy xy");
    EXPECT_EQ(std::ranges::find(read.fields, "mode", &Field::name)->codes, "surrogate replay");
}

TEST(RunFile, KeepsTheRowsOfRegions) {
    const Scratch folder;
    RunFile run = RunFile::create(folder.path(), info);
    run.follow({{"A", 15, {}}, {"B", 1, {}}});
    for (int k = 0; k < 3; ++k) {
        RegionRow a, b;
        a.d_over_B = b.d_over_B = 0.01 * k,
        a.p = {1e3 * k, 500.0 * k, 2e3 * k};  // F_a and others unknown: NaN
        run.append(std::vector{a, b});
    }
    run.commit();
    const auto regions = read_run(run.path()).regions;
    ASSERT_EQ(regions.size(), 2u);
    EXPECT_EQ(regions[0].name, "A");
    EXPECT_EQ(regions[0].points, 15);
    ASSERT_EQ(regions[0].rows.size(), 3u);
    EXPECT_EQ(regions[0].rows[2].p.max, 4e3);
    EXPECT_TRUE(std::isnan(regions[0].rows[2].anisotropy.mean));
    EXPECT_NE(test::contents(folder.path() / "regions.csv").find("A,15,0.02,2000,1000,4000"),
              std::string::npos);
}

TEST(RunFile, KeepsSceneSeriesFramesTimingsAndCounters) {
    const Scratch folder;
    RunFile run = RunFile::create(folder / "out", info);
    advance(run, 0, 25);
    run.set_timing("rve", 12.5);
    run.set_counter("updates", 42);
    run.commit();
    const RunRecord record = read_run(run.path());
    EXPECT_EQ(record.info.scene_text, info.scene_text);
    EXPECT_EQ(record.info.threads, 2);
    EXPECT_EQ(record.load.size(), 25u);
    EXPECT_EQ(record.load[7].load, row(7).load);
    EXPECT_EQ(record.timing.at("rve"), 12.5);
    EXPECT_EQ(record.counters.at("updates"), 42);
    ASSERT_EQ(record.frames, 2u);
    const Frame read = read_run_frame(run.path(), 1), written = frame(1);
    EXPECT_EQ(read.plate_y, written.plate_y);
    EXPECT_EQ(read.y, written.y);
    ASSERT_EQ(read.fields.size(), 2u);
    EXPECT_EQ(read.fields[0].name, "displacement");
    EXPECT_EQ(read.fields[0].unit, "m");
    EXPECT_EQ(read.fields[0].components, 2);
    EXPECT_EQ(read.fields[0].values, written.fields[0].values);
    EXPECT_THROW(read_run_frame(run.path(), 2), InputError);
}

TEST(RunFile, OfAnAuditedLoadKeepsItsErrorBar) {
    const Scratch folder;
    LoadRow one = row(0);
    one.corrected = 5, one.low = 4, one.high = 7;
    {
        RunFile run = RunFile::create(folder / "out", info, true);
        run.append(one);
        run.commit();
    }
    const RunRecord read = read_run(folder / "out/run.h5");
    EXPECT_TRUE(read.load_audited);
    EXPECT_EQ(read.load[0].high, 7);
    EXPECT_EQ(test::contents(folder / "out/load.csv"),
              load_csv_header(true) + "\n" + load_csv_line(one, true) + "\n");
    RunFile plain = RunFile::create(folder / "plain", info);
    plain.append(one);
    plain.commit();
    EXPECT_FALSE(read_run(folder / "plain/run.h5").load_audited);
}

TEST(RunFile, LoadCsvHasEveryRowBeforeAnyCommit) {
    const Scratch folder;
    RunFile run = RunFile::create(folder / "out", info);
    run.append(row(0));
    run.append(row(1));
    const std::string text = test::contents(folder / "out/load.csv");
    EXPECT_EQ(text, load_csv_header() + "\n" + load_csv_line(row(0)) + "\n" + load_csv_line(row(1)) + "\n");
    EXPECT_EQ(text.rfind("d_over_B,load_N_per_m,", 0), 0u);
}

TEST(RunFile, InterruptedRunEndsLikeTheUninterruptedOne) {
    const Scratch folder;
    RunFile whole = RunFile::create(folder / "whole", info);
    advance(whole, 0, 47);
    whole.commit();
    {
        RunFile run = RunFile::create(folder / "cut", info);
        advance(run, 0, 13);
        CheckpointWriter writer(folder / "cut/checkpoint.h5", {info.scene_hash, "", 0});
        run.archive(writer);
        writer.commit();
        advance(run, 13, 38);  // lost with the kill, though two more frames are on disk
    }
    RunFile run = RunFile::resume(folder / "cut", info);
    CheckpointReader reader(folder / "cut/checkpoint.h5", info.scene_hash);
    run.archive(reader);
    EXPECT_EQ(run.record().load.size(), 13u);
    EXPECT_EQ(run.record().frames, 1u);
    advance(run, 13, 47);
    run.commit();
    expect_same_outputs(folder / "whole", folder / "cut");
}

TEST(RunFile, RefusesToResumeAnotherSceneOrAShorterRun) {
    const Scratch folder;
    RunFile run = RunFile::create(folder / "out", info);
    RunInfo other = info;
    other.scene_hash = "ffff";
    EXPECT_THROW(RunFile::resume(folder / "out", other), InputError);
    EXPECT_THROW(RunFile::resume(folder / "nowhere", info), InputError);
    advance(run, 0, 5);
    CheckpointWriter writer(folder / "c.h5", {info.scene_hash, "", 0});
    run.archive(writer);
    writer.commit();
    RunFile fresh = RunFile::create(folder / "out", info);
    CheckpointReader reader(folder / "c.h5", info.scene_hash);
    EXPECT_THROW(fresh.archive(reader), InputError);
}

TEST(RunFile, RefusedResumeLeavesTheFolderAsItWas) {
    const Scratch folder;
    RunFile run = RunFile::create(folder / "out", info);
    advance(run, 0, 5);
    const std::string csv = test::contents(folder / "out/load.csv"),
                      h5 = test::contents(folder / "out/run.h5");
    RunFile again = RunFile::resume(folder / "out", info);
    EXPECT_THROW(CheckpointReader(folder / "out/checkpoint.h5", info.scene_hash), InputError);
    EXPECT_EQ(test::contents(folder / "out/load.csv"), csv);
    EXPECT_EQ(test::contents(folder / "out/run.h5"), h5);
}

TEST(RunFile, NewRunRemovesTheResultsOfAnOlderOne) {
    const Scratch folder;
    RunFile::create(folder / "out", info);
    fs::create_directories(folder / "out/packings");
    fs::create_directories(folder / "out/pictures");
    for (const char* name : {"out/summary.json", "out/checkpoint.h5", "out/checkpoint.h5.prev",
                             "out/packings/above_0010.h5", "out/pictures/strain_0010.png", "out/notes.txt"})
        test::overwrite(folder / name, "old");
    RunFile::create(folder / "out", info);
    EXPECT_TRUE(fs::is_empty(folder / "out/packings"));
    EXPECT_TRUE(fs::is_empty(folder / "out/pictures"));
    EXPECT_TRUE(fs::exists(folder / "out/notes.txt"));
    EXPECT_FALSE(fs::exists(folder / "out/summary.json"));
    EXPECT_FALSE(fs::exists(folder / "out/checkpoint.h5"));
    EXPECT_FALSE(fs::exists(folder / "out/checkpoint.h5.prev"));
}

TEST(RunFile, WriterKilledAtAnyMomentLeavesAReadableRun) {
    const Scratch folder;
    std::size_t rows = 0;
    for (int round = 0; round < 20; ++round) {
        RunFile::create(folder / "out", info);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            RunFile run = RunFile::resume(folder / "out", info);
            advance(run, 0, 1'000'000);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5 + 9 * round % 50));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const RunRecord record = read_run(folder / "out/run.h5");
        rows += record.load.size();
        for (std::size_t k = 0; k < record.load.size(); ++k) ASSERT_EQ(record.load[k].load, row(int(k)).load);
        for (std::size_t k = 0; k < record.frames; ++k)
            ASSERT_EQ(read_run_frame(folder / "out/run.h5", k).y, frame(int(k)).y);
        const std::string csv = test::contents(folder / "out/load.csv");
        EXPECT_EQ(csv.back(), '\n');
        EXPECT_GE(std::count(csv.begin(), csv.end(), '\n'), static_cast<long>(record.load.size() + 1));
    }
    EXPECT_GT(rows, 0u);  // the child did write
}

}  // namespace
}  // namespace sandgraph::io
