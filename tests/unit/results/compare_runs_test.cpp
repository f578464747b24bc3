#include "results/compare_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "io/run_file.hpp"
#include "results/screening_summary.hpp"
#include "tests/unit/io/scratch.hpp"

// Runs made by hand, whose differences are known.
namespace sandgraph::results {
namespace {

io::Frame frame(double d, double shift, double stress) {
    io::Frame f{d, d, 0, 1, {0.5, 1.5}, {0.5, 0.5}, {}};
    f.fields = {{"displacement", "m", 2, {0, shift, 0, 0}},
                {"stress", "Pa", 3, {2e4 + stress, 2e4, 0, 100, 100, stress}}};
    return f;
}

// A load of `peak` d (2 - d/0.02)/0.02 to 0.04, in a folder of its own with a frame at 0.02.
FinishedRun run(const test::Scratch& scratch, const std::string& name, double peak, double shift = 0,
                double stress = 0) {
    FinishedRun out;
    out.folder = scratch / name;
    std::filesystem::create_directories(out.folder);
    io::RunFile file = io::RunFile::create(out.folder, {"", "hash", "0.1", "git", "full", 1});
    file.append(frame(0, 0, 0));
    for (int k = 0; k <= 80; ++k) {
        io::LoadRow row;
        row.d_over_B = 0.0005 * k;
        const double t = row.d_over_B / 0.02;
        row.load = peak * t * (2 - t);
        file.append(row);
    }
    file.append(frame(0.02, shift, stress));
    file.commit();
    out.record = io::read_run(out.folder / "run.h5");
    out.scene.anchor.width = 0.5;
    out.summary.points = 2, out.summary.breakout_load = peak, out.summary.breakout_d_over_B = 0.02;
    out.summary.wall_s = 10, out.summary.cpu_s = 20, out.summary.dem_steps = 1000;
    out.summary.extra = {{"breakout_criterion", 0.0}};
    return out;
}

TEST(CompareRuns, ErrorsOfTheLoadAreSharesOfTheReferencesPeak) {
    const test::Scratch scratch;
    FinishedRun reference = run(scratch, "a", 1000), other = run(scratch, "b", 900);
    other.summary.breakout_d_over_B = 0.025;
    const Comparison c = compare_runs(reference, other);
    EXPECT_NEAR(c.peak_error, 0.1, 1e-12);
    EXPECT_NEAR(c.peak_position_error, 0.005, 1e-12);
    // rms of 0.1 t (2 - t) over t = 0 .. 2 is 0.1 sqrt(8/15).
    EXPECT_NEAR(c.curve_error, 0.1 * std::sqrt(8.0 / 15), 1e-3);
    EXPECT_NEAR(c.curve_error_smoothed, c.curve_error, 1e-3);
    EXPECT_NEAR(c.common, 0.04, 1e-12);
}

// A curve of half the points lies on the other's straight pieces.
TEST(CompareRuns, ReadsACurveBetweenItsRows) {
    const test::Scratch scratch;
    FinishedRun reference = run(scratch, "a", 1000), coarse = reference;
    std::erase_if(coarse.record.load,
                  [](const io::LoadRow& row) { return std::lround(2000 * row.d_over_B) % 2; });
    EXPECT_LT(compare_runs(reference, coarse).curve_error, 1e-3);
}

TEST(CompareRuns, FieldsAreComparedAtCommonFramesApartFromTheStart) {
    const test::Scratch scratch;
    const Comparison c = compare_runs(run(scratch, "a", 1000), run(scratch, "b", 1000, 0.004, 600));
    EXPECT_EQ(c.frames, 1);
    // Of two points one is off, by 0.004 m of a pull of 0.02 * 0.5 m.
    EXPECT_NEAR(c.displacement_error, 0.4 / std::sqrt(2.0), 1e-9);
    // 600 Pa of 20 kPa along x; 600 Pa of shear, twice in the tensor, of the 1 kPa that is the least.
    EXPECT_NEAR(c.stress_error, std::sqrt((0.03 * 0.03 + 2 * 0.6 * 0.6) / 2), 1e-9);
}

TEST(CompareRuns, TimesAreThoseOfTheReferenceOverTheOthers) {
    const test::Scratch scratch;
    FinishedRun reference = run(scratch, "a", 1000), other = run(scratch, "b", 1000);
    other.summary.wall_s = 2, other.summary.cpu_s = 5;
    other.summary.extra.emplace_back("dem_steps_replay", 250);
    const Comparison c = compare_runs(reference, other);
    EXPECT_DOUBLE_EQ(c.wall_ratio, 5);
    EXPECT_DOUBLE_EQ(c.cpu_ratio, 4);
    EXPECT_DOUBLE_EQ(c.replay_share, 0.25);
    other.record.load.resize(60);
    EXPECT_TRUE(std::isnan(compare_runs(reference, other).wall_ratio)) << "of runs to different ends";
}

// A law that is nothing but its log.
struct Logged : stress::Law {
    void initialise(const stress::Batch&) override {}
    void update(const stress::Batch&) override {}
    double p_wave_modulus() const override { return 1; }
    void archive(Archive&) override {}
    stress::Answers answers() const override { return stress::Answers::screening; }
    const stress::ScreeningLog* screening_log() const override { return &log; }
    stress::GrainUse grain_use() const override { return {5, 100, 10, 0}; }
    stress::AuditRow audit() const override { return {0, 3, 45, 0.02, 0.01}; }
    stress::ScreeningLog log;
};

TEST(ScreeningSummary, SharesAreOfThePointsAndOfTheSteps) {
    Logged law;
    law.log.counters.steps = 10, law.log.counters.dem_points = 100;
    io::Summary s;
    add_screening(law, 50, s);
    EXPECT_DOUBLE_EQ(s.dem_fraction_final, 0.1);
    EXPECT_DOUBLE_EQ(s.dem_fraction_mean, 0.2);
    EXPECT_EQ(s.audit.points, 3);
    EXPECT_EQ(s.audit.stress_error_mean, 0.02);
}

TEST(ScreeningSummary, QuantilesOfTheJumpsAreWhatTheirNamesSay) {
    Logged law;
    for (int k = 100; k >= 0; --k) {
        stress::Switch one;
        one.reason = k % 2 ? stress::Reason::strain : stress::Reason::tension;
        one.jump = 0.01 * k, one.felt = 0.001 * k, one.ordinary = 0.0001 * k;
        law.log.switches.push_back(one);
    }
    io::Summary s;
    add_screening(law, 50, s);
    EXPECT_NEAR(s.number("jump_p50"), 0.5, 1e-12);
    EXPECT_NEAR(s.number("jump_p95"), 0.95, 1e-12);
    EXPECT_NEAR(s.number("jump_max"), 1, 1e-12);
    EXPECT_NEAR(s.number("jump_felt_p95"), 0.095, 1e-12);
    EXPECT_NEAR(s.number("ordinary_step_p95"), 0.0095, 1e-12);
    EXPECT_EQ(s.number("switches strain"), 50);
    EXPECT_EQ(s.number("switches tension"), 51);
}

}  // namespace
}  // namespace sandgraph::results
