#include "results/sweep_results.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "base/process.hpp"
#include "io/atomic_file.hpp"
#include "support/small_sweep.hpp"

namespace sandgraph::results {
namespace {

using support::SmallSweep;

constexpr const char* kAxis = "[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [1, 2]\n";

// Cells of line `line` by their column.
std::string cell(const std::string& csv, std::size_t line, const std::string& column) {
    std::istringstream in(csv);
    std::vector<std::string> lines;
    for (std::string text; std::getline(in, text);) lines.push_back(text);
    std::istringstream names(lines.at(0)), values(lines.at(line));
    for (std::string name, value; std::getline(names, name, ',');) {
        std::getline(values, value, ',');
        if (name == column) return value;
    }
    return "no column " + column;
}

TEST(SweepResults, ARowHasTheMeanOfItsSamplesAndStudentsInterval) {
    const SmallSweep sweep("mean");
    const auto plan = sweep.plan(std::string("samples = 3\n") + kAxis);
    ASSERT_EQ(plan.runs.size(), 6u);
    for (std::size_t k = 0; k < 3; ++k) sweep.finish(plan.runs[k], 2 + 0.1 * double(k));
    const auto rows = sweep_results(plan);
    const std::string csv = sweep_table_csv(plan, rows);
    EXPECT_EQ(cell(csv, 1, "row"), "embedment_ratio=1");
    EXPECT_EQ(cell(csv, 1, "anchor.embedment_ratio"), "1");
    EXPECT_EQ(cell(csv, 1, "n_gamma"), "2.1");
    EXPECT_EQ(cell(csv, 1, "n_gamma_sd"), "0.1");
    EXPECT_NEAR(std::stod(cell(csv, 1, "n_gamma_ci95")), 4.303 * 0.1 / std::sqrt(3.), 1e-5);
    EXPECT_EQ(cell(csv, 1, "n_gamma_p50"), "2.1");
    EXPECT_EQ(cell(csv, 1, "n_gamma_formula"), "2.5");  // pulled up: Meyerhof & Adams
    EXPECT_EQ(cell(csv, 1, "peak_load_N_per_m"), "2100");
    EXPECT_EQ(cell(csv, 1, "cpu_s"), "9.00");  // sums
    EXPECT_EQ(cell(csv, 1, "dem_steps"), "300");
    EXPECT_EQ(cell(csv, 1, "warnings"), "3");
    EXPECT_EQ(cell(csv, 1, "status"), "finished");
    EXPECT_EQ(cell(csv, 2, "n_gamma"), "");
    EXPECT_EQ(cell(csv, 2, "status"), "waiting");
}

TEST(SweepResults, ARunThatHasNotBrokenOutHasNoFactorButALoad) {
    const SmallSweep sweep("rising");
    const auto plan = sweep.plan(std::string("samples = 2\n") + kAxis);
    sweep.finish(plan.runs[0], 2);
    io::Summary rising;
    rising.scene_hash = plan.runs[1].scene_hash, rising.breakout_load = 4000;
    sweep.finish(plan.runs[1], rising);
    const std::string csv = sweep_table_csv(plan, sweep_results(plan));
    EXPECT_EQ(cell(csv, 1, "finished"), "2");
    EXPECT_EQ(cell(csv, 1, "breakouts"), "1");
    EXPECT_EQ(cell(csv, 1, "n_gamma"), "2");
    EXPECT_EQ(cell(csv, 1, "n_gamma_ci95"), "");
    EXPECT_EQ(cell(csv, 1, "peak_load_N_per_m"), "3000");
}

TEST(SweepResults, AFailedRunMakesItsRowFailedAndTellsWhy) {
    const SmallSweep sweep("failed");
    const auto plan = sweep.plan(std::string("samples = 2\n") + kAxis);
    sweep.finish(plan.runs[0], 2);
    std::filesystem::create_directories(plan.runs[1].folder());
    io::write_text(plan.runs[1].failure(), "ended by signal 9, and more\n");
    const auto rows = sweep_results(plan);
    EXPECT_EQ(cell(sweep_table_csv(plan, rows), 1, "status"), "failed");
    EXPECT_EQ(cell(sweep_table_csv(plan, rows), 1, "finished"), "1");
    EXPECT_NE(sweep_samples_csv(plan, rows).find("\"ended by signal 9, and more\""), std::string::npos);
}

TEST(SweepResults, AFolderOfAnotherSceneIsRefused) {
    const SmallSweep sweep("other");
    const auto plan = sweep.plan(kAxis);
    io::Summary other;
    other.scene_hash = "0123";
    sweep.finish(plan.runs[0], other);
    EXPECT_THROW(sweep_results(plan), InputError);
}

// Of a scene's seed the first sample is the scene itself: more samples later leave it as it is.
TEST(SweepPlan, SamplesDifferByTheirSeedAndTheFirstIsTheScenes) {
    const SmallSweep sweep("seeds");
    const auto three = sweep.plan("samples = 3\n").runs, two = sweep.plan("samples = 2\n").runs;
    EXPECT_EQ(three[0].scene.ground.grains.seed, scene::Grains{}.seed);
    EXPECT_EQ(three[1].scene_hash, two[1].scene_hash);
    EXPECT_NE(three[0].scene_hash, three[1].scene_hash);
    EXPECT_NE(three[1].scene_hash, three[2].scene_hash);
}

TEST(SweepPlan, ARowThatIsNoSceneIsRefusedWithItsName) {
    const SmallSweep sweep("deep");
    try {
        sweep.plan("[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [1, 20]\n");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("t.toml:2: row embedment_ratio=20"), std::string::npos)
            << error.what();
    }
}

TEST(SweepPlan, SamplesOfAClosedFormLawAreRefused) {
    const SmallSweep sweep("closed");
    EXPECT_THROW(sweep.plan("samples = 2\n[set]\nground.law = \"mohr_coulomb\"\n"), InputError);
    EXPECT_NO_THROW(sweep.plan(std::string(kAxis) + "[set]\nground.law = \"mohr_coulomb\"\n"));
}

TEST(SweepPlan, JobsThatMayNotFitTheMemoryAreRefused) {
    const SmallSweep sweep("memory");
    auto plan = sweep.plan(std::string("samples = 2\n") + kAxis);
    for (simulation::SweepRun& run : plan.runs) run.estimate.bytes = 0.4 * memory_limit();
    const auto runs = simulation::unfinished(plan);
    EXPECT_EQ(simulation::room_for(runs), 2);
    EXPECT_NO_THROW(simulation::require_room(runs, 2));
    EXPECT_THROW(simulation::require_room(runs, 3), InputError);
}

}  // namespace
}  // namespace sandgraph::results
