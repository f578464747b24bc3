#include "simulation/history_recorder.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <set>

#include "base/error.hpp"
#include "io/history_file.hpp"
#include "mpm/layout.hpp"
#include "scene/read_scene.hpp"
#include "simulation/history_points.hpp"
#include "simulation/scene_spec.hpp"
#include "support/paths.hpp"
#include "surrogate/load_surrogate.hpp"
#include "tests/unit/io/scratch.hpp"
#include "tests/unit/simulation/grain_scene.hpp"

namespace sandgraph::simulation {
namespace {

const std::string kScene = test::grain_scene(3, R"([grains]
count = 60
[output]
history = true
history_points = 10
)");

scene::Scene small_scene() { return scene::parse_scene(kScene, "s.toml", {}); }

const packings::PreparedGround& ground() {
    static const packings::PreparedGround prepared = test::freshly_prepared(small_scene());
    return prepared;
}

// Runs some steps with a log.
io::HistoryLog logged(const scene::Scene& scene, const packings::PreparedGround& prepared, int threads,
                      int steps, bool* full = nullptr) {
    const test::Scratch folder;
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    const auto pull = simulation_of(scene, prepared);
    HistoryRecorder recorder(scene, prepared, *pull, folder.path(), false);
    BackgroundWriter writer;
    for (int step = 0; step < steps; ++step) {
        pull->step();
        recorder.after_step(*pull, writer);
    }
    writer.drain();
    recorder.write();
    if (full) *full = recorder.full();
    EXPECT_EQ(io::read_history(folder / "history.h5").rows.size(), recorder.rows());
    return io::read_history(folder / "history.h5");
}

io::HistoryLog logged(const scene::Scene& scene, int threads, int steps, bool* full = nullptr) {
    const packings::PreparedGround& prepared =
        ground();  // before the test's folder, whose name its cache has, too
    return logged(scene, prepared, threads, steps, full);
}

constexpr int kSteps = 1500;
const io::HistoryLog& log() {
    static const io::HistoryLog made = logged(small_scene(), 2, kSteps);
    return made;
}

// Driven through the row's initial packing, logged increments give the logged stress bit for bit. Answers how
// many rows there were.
std::size_t replayed(const io::HistoryLog& log, io::HistoryMode mode) {
    const scene::Ground& g = small_scene().ground;
    const dem::RveOptions options =
        dem::rve_options(g.rve, g.grains.material, ground().packings[0].packing->grains->radius);
    dem::Workspace work;
    std::size_t rows = 0;
    for (std::size_t h = 0; h < log.histories.size(); ++h) {
        const auto row = static_cast<std::size_t>(log.histories[h].packing);
        EXPECT_EQ(log.packings[row].stress, ground().packings[row].packing->stress);
        dem::Rve rve(ground().packings[row].packing);
        for (const io::HistoryRow& update : log.of(h)) {
            rve.update(update.F_inc, g.grains.material, options, work);
            EXPECT_EQ(rve.stress(), update.stress);
            EXPECT_EQ(rve.volume_ratio(), update.volume_ratio);
            EXPECT_EQ(update.mode, mode);
            ++rows;
        }
    }
    return rows;
}

TEST(HistoryRecorder, LogIsThePackingsHistory) { EXPECT_GT(replayed(log(), io::HistoryMode::dem), 100u); }

// What a screening run is retrained from: grains along the strain that the surrogate led to.
TEST(HistoryRecorder, LogOfAScreeningRunIsThatOfItsAuditedPackings) {
    const std::vector<std::string> set = {
        "mode=screening", "audit.share=0.05", "gate.active=false",
        "surrogate.model=" + sandgraph::test::source_file("/configs/models/table1.surrogate.h5")};
    const scene::Scene scene = scene::parse_scene(kScene, "s.toml", set);
    packings::PreparedGround screened = ground();
    screened.surrogate =
        surrogate::load_surrogate(sandgraph::test::source_file("/configs/models/table1.surrogate.h5"));
    const io::HistoryLog log = logged(scene, screened, 2, kSteps);
    EXPECT_GT(replayed(log, io::HistoryMode::audit), 100u);
}

TEST(HistoryRecorder, TimeBetweenRowsAddsUpToNoMoreThanTheRun) {
    const auto pull = simulation_of(small_scene(), ground());
    const double end = kSteps * pull->state().settings.dt;
    for (std::size_t h = 0; h < log().histories.size(); ++h) {
        double time = 0;
        for (const io::HistoryRow& update : log().of(h)) {
            EXPECT_GT(update.dt, 0);
            time += update.dt;
        }
        EXPECT_LE(time, end * (1 + 1e-9));
    }
}

TEST(HistoryRecorder, LogsTheSameAtAnyThreadCount) {
    const io::HistoryLog one = logged(small_scene(), 1, kSteps);
    ASSERT_EQ(one.begin, log().begin);
    for (std::size_t k = 0; k < one.rows.size(); ++k) {
        ASSERT_EQ(one.rows[k].stress, log().rows[k].stress);
        ASSERT_EQ(one.rows[k].F_inc, log().rows[k].F_inc);
        ASSERT_EQ(one.rows[k].energy, log().rows[k].energy);
    }
}

TEST(HistoryRecorder, StopsAtItsSizeAndSaysSo) {
    scene::Scene scene = small_scene();
    scene.output.history_max = 40 * static_cast<double>(io::HistoryJournal::row_bytes());
    bool full = false;
    const io::HistoryLog cut = logged(scene, 2, kSteps, &full);
    EXPECT_TRUE(full);
    EXPECT_EQ(cut.rows.size(), 40u);
    for (std::size_t h = 0; h < cut.histories.size(); ++h)
        for (std::size_t k = 0; k < cut.of(h).size(); ++k)
            EXPECT_EQ(cut.of(h)[k].stress, log().of(h)[k].stress);
}

TEST(HistoryRecorder, RefusesGroundWithoutGrains) {
    scene::Scene scene = small_scene();
    scene.ground.law = scene::Law::elastic;
    const packings::PreparedGround elastic = packings::prepare_ground(scene);
    const auto pull = simulation_of(scene, elastic);
    const test::Scratch folder;
    EXPECT_THROW(HistoryRecorder(scene, elastic, *pull, folder.path(), false), InputError);
}

TEST(HistoryPoints, AreSpreadAndDenserNearThePlate) {
    const mpm::Rectangle plate{-0.5, 3, 0.5, 3.1};
    const mpm::Points points = mpm::lay_out({{0, 0, 6, 5}, 0.1, 1, 2200, {plate}});
    const auto chosen = history_points(points, plate, 1, 64, 1);
    EXPECT_EQ(std::set(chosen.begin(), chosen.end()).size(), 64u);
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    int edge = 0, far = 0;
    for (const std::int32_t p : chosen) {
        edge += std::hypot(points.x[p] - 0.5, points.y[p] - 3.05) < 0.6;
        far += points.x[p] > 3;
    }
    EXPECT_GE(edge, 16);
    EXPECT_GE(far, 8);
    EXPECT_EQ(history_points(points, plate, 1, 64, 1), chosen);
    EXPECT_NE(history_points(points, plate, 1, 64, 2), chosen);
    EXPECT_EQ(history_points(points, plate, 1, 100000, 1).size(), points.size());
}

}  // namespace
}  // namespace sandgraph::simulation
