#include "laboratory/probe.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/LU>
#include <cstdlib>
#include <set>

#include "dem/stretch.hpp"
#include "io/history_file.hpp"
#include "laboratory/probe_plan.hpp"
#include "packings/compressed_packings.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::laboratory {
namespace {

using io::HistoryPath;
using io::HistoryTwin;

scene::ProbeSpec small_probe() {
    scene::ProbeSpec spec;
    spec.text = "small";
    spec.grains.count = 60;
    spec.packings = {2, 1, {0.16, 0.20}, 2, 5e3, 50e3};
    spec.paths = {1, 1, 3, 2, 1, 2, 3, 2};
    spec.paths.length_max = 0.02, spec.paths.rows_max = 100, spec.paths.dither_rows = 200;
    spec.paths.flow_rows = 600, spec.paths.flow_length = 0.2;
    spec.paths.twin_every = 4;
    return spec;
}

// One log for all tests of this program that only look.
const io::HistoryLog& small_log() {
    static const io::HistoryLog log = [] {
        const test::Scratch folder;
        setenv("SANDGRAPH_CACHE", (folder / "cache").c_str(), 1);
        write_probe(small_probe(), folder / "log.h5");
        return io::read_history(folder / "log.h5");
    }();
    return log;
}

bool same(const io::HistoryLog& a, const io::HistoryLog& b) {
    if (a.rows.size() != b.rows.size() || a.begin != b.begin) return false;
    for (std::size_t k = 0; k < a.rows.size(); ++k)
        if (a.rows[k].F_inc != b.rows[k].F_inc || a.rows[k].stress != b.rows[k].stress ||
            a.rows[k].energy != b.rows[k].energy)
            return false;
    return true;
}

TEST(Probe, GivesTheSameDataAtAnyThreadCountAndOtherDataForAnotherSeed) {
    const test::Scratch folder;
    setenv("SANDGRAPH_CACHE", (folder / "cache").c_str(), 1);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    write_probe(small_probe(), folder / "again.h5");
    EXPECT_TRUE(same(small_log(), io::read_history(folder / "again.h5")));
    scene::ProbeSpec other = small_probe();
    other.seed = 2;
    write_probe(other, folder / "other.h5");
    EXPECT_FALSE(same(small_log(), io::read_history(folder / "other.h5")));
}

// The log is the packing's history: its increments, driven through the initial packing, give its stress.
TEST(Probe, HistoriesReplayToTheLoggedStressBitForBit) {
    const io::HistoryLog& log = small_log();
    const test::Scratch folder;
    setenv("SANDGRAPH_CACHE", (folder / "cache").c_str(), 1);
    const ProbePlan plan = plan_probe(small_probe());
    const scene::ProbeSpec spec = small_probe();
    const dem::Material material = spec.grains.material;
    dem::Workspace work;
    for (const std::size_t h : {std::size_t{0}, std::size_t{3}, log.histories.size() - 1}) {
        const PackingPlan& packing = plan.packings[static_cast<std::size_t>(log.histories[h].packing)];
        dem::Rve rve(packings::CompressedPackings(packing.grains).row(packing.pressure).packing);
        const dem::RveOptions options = dem::rve_options(spec.rve, material, rve.packing().grains->radius);
        ASSERT_GT(log.of(h).size(), 1u);
        for (const io::HistoryRow& row : log.of(h)) {
            rve.update(row.F_inc, material, options, work);
            ASSERT_EQ(rve.stress(), row.stress);
            ASSERT_EQ(rve.volume_ratio(), row.volume_ratio);
        }
    }
}

TEST(Probe, LogsEveryKindOfPathAndItsPackings) {
    const io::HistoryLog& log = small_log();
    std::multiset<HistoryPath> paths;
    for (const io::HistoryInfo& info : log.histories)
        if (info.twin == HistoryTwin::none) paths.insert(info.path);
    EXPECT_EQ(paths.count(HistoryPath::constant_pressure), 3u);
    EXPECT_EQ(paths.count(HistoryPath::dither), 1u);
    EXPECT_EQ(paths.count(HistoryPath::critical_shear), 2u);
    EXPECT_EQ(paths.size(), 15u);
    ASSERT_EQ(log.packings.size(), 8u);
    for (const io::HistoryPacking& p : log.packings) {
        EXPECT_NEAR(p.traits.porosity, p.target_porosity, 0.01);
        EXPECT_NEAR(p.traits.pressure, 0.5 * p.stress.trace(), 1e-3 * p.traits.pressure);
        EXPECT_GT(p.traits.peak_friction, 0.2);
        EXPECT_LT(p.traits.peak_friction, 0.8);
    }
}

TEST(Probe, PointsOfConstantPressureKeepItAndThoseOfConstantVolumeTheirVolume) {
    const io::HistoryLog& log = small_log();
    for (std::size_t h = 0; h < log.histories.size(); ++h) {
        if (log.histories[h].twin != HistoryTwin::none) continue;
        const double start = log.packings[static_cast<std::size_t>(log.histories[h].packing)].traits.pressure;
        for (const io::HistoryRow& row : log.of(h)) {
            if (log.histories[h].path == HistoryPath::constant_pressure) {
                EXPECT_GT(row.p, 0.2 * start);
                EXPECT_LT(row.p, 5 * start);
            }
            if (log.histories[h].path == HistoryPath::constant_volume) {
                EXPECT_NEAR(row.volume_ratio, 1, 1e-3);
            }
        }
    }
}

// Row of the twin that has gone as far as row `row` of its original, or -1.
long matching(HistoryTwin twin, long row) {
    if (twin == HistoryTwin::finer) return 10 * row + 9;
    if (twin == HistoryTwin::coarser) return row % 10 == 9 ? row / 10 : -1;
    return row;
}

Mat2 total(std::span<const io::HistoryRow> rows, long last) {
    Mat2 F = Mat2::Identity();
    for (long k = 0; k <= last; ++k) F = rows[static_cast<std::size_t>(k)].F_inc * F;
    return F;
}

TEST(Probe, TwinsRepeatTheStrainOfTheirOriginal) {
    const io::HistoryLog& log = small_log();
    std::set<HistoryTwin> seen;
    for (std::size_t h = 0; h < log.histories.size(); ++h) {
        const io::HistoryInfo& twin = log.histories[h];
        if (twin.twin == HistoryTwin::none) continue;
        const auto original = log.of(static_cast<std::size_t>(twin.twin_of)), repeated = log.of(h);
        const long row = std::min<long>(9, static_cast<long>(original.size()) - 1);
        const long match = matching(twin.twin, row);
        if (match < 0 || match >= static_cast<long>(repeated.size())) continue;
        const Mat2 Q = dem::rotation(twin.rotation);
        EXPECT_LT((total(repeated, match) - Q * total(original, row) * Q.transpose()).norm(), 1e-12);
        seen.insert(twin.twin);
        const io::HistoryInfo& first = log.histories[static_cast<std::size_t>(twin.twin_of)];
        EXPECT_EQ(first.path, twin.path);
        const bool other_seed = log.packings[twin.packing].seed != log.packings[first.packing].seed;
        EXPECT_EQ(other_seed, twin.twin == HistoryTwin::other_seed);
        EXPECT_EQ(twin.packing == first.packing, !other_seed);
    }
    EXPECT_EQ(seen.size(), 4u);
}

}  // namespace
}  // namespace sandgraph::laboratory
