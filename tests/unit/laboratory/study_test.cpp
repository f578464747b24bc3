#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dem/element_test/element_test.hpp"
#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "laboratory/study_table.hpp"
#include "support/paths.hpp"

namespace sandgraph::laboratory {
namespace {

const StudySample& sample() {
    static const StudySample packing = [] {
        const dem::Material material;
        dem::FastAssembly a(dem::read_packing_csv(sandgraph::test::test_data("/yade/packing_dense_p32.csv")),
                            material);
        a.step(Mat2::Zero(), 1e-5, 4000);
        return StudySample{{dem::compact(a.packing(), material, a.stress()), {2.0e7, 1.4e7}}, material};
    }();
    return packing;
}

Mat2 total(const StrainHistory& history) {
    Mat2 F = Mat2::Identity();
    for (const Mat2& F_inc : history.increments) F = F_inc * F;
    return F;
}

// A run whose stress stays isotropic at p.
StudyRun constant_run(double p, std::size_t steps) {
    StudyRun run;
    run.stress.assign(steps, Stress{-p, -p, 0});
    return run;
}

TEST(StrainHistory, ShearBeforeThePeakKeepsTheVolume) {
    EXPECT_NEAR(total(biaxial_history(0.01)).determinant(), 1, 1e-6);
    EXPECT_NEAR(total(biaxial_history(0.01))(0, 0), 1.01, 1e-4);
    EXPECT_NEAR(total(simple_shear_history(0.01))(0, 1), 0.01, 1e-12);
}

TEST(StrainHistory, QuietNoiseHasNoMeanButItsTrend) {
    const StrainHistory quiet = quiet_history();
    const Mat2 F = total(quiet);
    const double noise = 5 * 3e-7 * std::sqrt(static_cast<double>(quiet.increments.size()) / 3);
    EXPECT_NEAR(F(0, 0) - 1, 1e-4, noise);
    EXPECT_NEAR(F(0, 1), 0, noise);
    EXPECT_GT(quiet.length(), 5 * (F - Mat2::Identity()).norm());
}

TEST(StrainHistory, ReversalPassesTheFirstTurnAgain) {
    EXPECT_NEAR(total(reversal_history())(0, 0) - 1, 0.0075, 1e-4);
    EXPECT_NEAR(reversal_history().length(), 0.0125 * std::sqrt(2.0), 1e-8);
}

TEST(StrainHistory, OpenedGroundEndsDenserThanItBegan) {
    EXPECT_LT(total(recontact_history()).determinant(), 1);
}

TEST(StudySetting, EachVariationDiffersFromTheDefaultAndFromTheOthers) {
    for (const bool quick : {true, false}) {
        const auto settings = study_settings(quick);
        EXPECT_EQ(settings[study_default].key, "default");
        EXPECT_EQ(settings[study_peers].stepping.update_tolerance, 0);
        for (std::size_t a = study_default; a < settings.size(); ++a)
            for (std::size_t b = a + 1; b < settings.size(); ++b) {
                const graph::RveSettings &s = settings[a].stepping, &t = settings[b].stepping;
                EXPECT_FALSE(s.time_step_fraction == t.time_step_fraction && s.steps_min == t.steps_min &&
                             s.inertial_number_max == t.inertial_number_max &&
                             s.strain_per_step_max == t.strain_per_step_max &&
                             s.update_tolerance == t.update_tolerance &&
                             s.stress_per_step_max == t.stress_per_step_max &&
                             s.pressure_floor == t.pressure_floor &&
                             s.update_change_max == t.update_change_max)
                    << settings[a].key << settings[a].value << settings[b].key << settings[b].value;
            }
    }
}

// Both shear stresses of the tensor are off.
TEST(StudyError, CountsShearTwice) {
    const std::vector<StudyRun> reference{constant_run(30000, 10)};
    std::vector<StudyRun> run = reference;
    for (Stress& s : run.front().stress) s.xy += 300;
    EXPECT_NEAR(study_error(run, reference, biaxial_history(0.01), 1000).rms, 0.01 * std::sqrt(2.0), 1e-12);
}

TEST(StudyError, PointwiseIsTheShareOfTheReferencePressure) {
    const std::vector<StudyRun> run{constant_run(30300, 10)}, reference{constant_run(30000, 10)};
    const StudyError error = study_error(run, reference, biaxial_history(0.01), 1000);
    EXPECT_NEAR(error.rms, 0.01 * std::sqrt(2.0), 1e-12);  // Frobenius: both normal stresses are off
    EXPECT_NEAR(error.max, error.rms, 1e-12);
    EXPECT_NEAR(error.pressure, 30000, 1e-8);
    EXPECT_EQ(error.scatter, 0);
}

TEST(StudyError, BelowTheFloorTheFloorIsTheScale) {
    const std::vector<StudyRun> run{constant_run(10, 4)}, reference{constant_run(0, 4)};
    EXPECT_NEAR(study_error(run, reference, opening_history(), 1000).max, 0.01 * std::sqrt(2.0), 1e-12);
}

TEST(StudyError, PastThePeakNoiseAboutTheSameMeanIsNoError) {
    StrainHistory history{"", 30e3, {}};
    history.window = 50;
    std::vector<StudyRun> noisy{constant_run(30000, 150), constant_run(20000, 150)};
    const std::vector<StudyRun> reference = noisy;
    for (StudyRun& run : noisy)
        for (std::size_t k = 0; k < run.stress.size(); ++k) run.stress[k].xx += k % 2 ? 5000 : -5000;
    const StudyError error = study_error(noisy, reference, history, 1000);
    EXPECT_LT(error.max, 1e-12);
    // Two seeds 10 kPa apart in both normal stresses: deviation 10 sqrt(2)/sqrt(2) kPa about 25 kPa.
    EXPECT_NEAR(error.scatter, 10.0 / 25, 1e-12);
    EXPECT_NEAR(error.of_means, 0, 1e-12);
}

TEST(StudyError, PastThePeakPackingsThatChangePlacesKeepTheMean) {
    StrainHistory history{"", 30e3, {}};
    history.window = 50;
    const std::vector<StudyRun> reference{constant_run(30000, 150), constant_run(20000, 150)},
        swapped{reference[1], reference[0]}, low{reference[1], reference[1]};
    EXPECT_GT(study_error(swapped, reference, history, 1000).rms, 0.3);
    EXPECT_NEAR(study_error(swapped, reference, history, 1000).of_means, 0, 1e-12);
    EXPECT_NEAR(study_error(low, reference, history, 1000).of_means, 5 * std::sqrt(2.0) / 25, 1e-12);
}

TEST(StudyRun, PeersRuleTakesTwoStepsAnIncrementAndMore) {
    StrainHistory history{"", study_pressure, {}};
    history.increments.assign(50, Mat2::Identity() + (Mat2() << 1e-7, 0, 0, -1e-7).finished());
    EXPECT_EQ(run_history(sample(), history, peers_stepping()).dem_steps, 100);
    history.increments.assign(10, Mat2::Identity() + (Mat2() << 5e-5, 0, 0, -5e-5).finished());
    EXPECT_EQ(run_history(sample(), history, peers_stepping()).dem_steps, 80);  // 7.07e-5 of strain each
}

TEST(StudyRun, TwoFineAnswersAgreeBetterThanTheDefault) {
    const StrainHistory history = biaxial_history(0.001);
    const std::vector<StudyRun> fine{run_history(sample(), history, reference_stepping())},
        twin{run_history(sample(), history, twin_stepping())}, usual{run_history(sample(), history, {})};
    const double floor = 1000;
    EXPECT_LT(study_error(twin, fine, history, floor).rms, study_error(usual, fine, history, floor).rms);
    EXPECT_LT(usual[0].dem_steps, fine[0].dem_steps / 4);
    EXPECT_EQ(fine[0].failures, 0);
}

TEST(StudyRun, TheDefaultErrsByThirtyPascalAtMostNearZeroPressure) {
    StudySample low = sample();
    dem::FastAssembly a(dem::read_packing_csv(sandgraph::test::test_data("/yade/packing_dense_p10.csv")),
                        low.material);
    dem::compress(a, {.pressure = study_pressure_low, .rate = 0.05},
                  dem::grain_scale(a.packing(), low.material));
    low.row.packing = dem::compact(a.packing(), low.material, a.stress());
    const StrainHistory history = opening_history();
    graph::RveSettings bare;
    bare.stress_per_step_max = 1e6;
    const std::vector<StudyRun> fine{run_history(low, history, reference_stepping())},
        usual{run_history(low, history, {})}, unsettled{run_history(low, history, bare)};
    const double error = study_error(usual, fine, history, 1000).rms;
    EXPECT_LT(error, 0.03) << "of a kPa";
    EXPECT_GT(study_error(unsettled, fine, history, 1000).rms, 1.5 * error);
}

TEST(StudyTable, ReferenceHasNoErrorAndPeersAreTheUnitOfCost) {
    const StrainHistory history = biaxial_history(0.0002);
    const std::vector<StudySetting> settings = study_settings(true);
    std::vector<std::vector<StudyRun>> runs;
    for (const StudySetting& s : settings) runs.push_back({run_history(sample(), history, s.stepping)});
    const auto rows = study_rows(history, settings, runs);
    EXPECT_EQ(rows[study_reference].error.rms, 0);
    EXPECT_EQ(rows[study_peers].of_peers, 1);
    const std::string csv = study_csv(rows);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), settings.size() + 1);
}

}  // namespace
}  // namespace sandgraph::laboratory
