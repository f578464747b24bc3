#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "report/biaxial_picture.hpp"
#include "report/breakout_picture.hpp"
#include "report/colour_scale.hpp"
#include "report/field_picture.hpp"
#include "report/load_picture.hpp"
#include "report/packing_picture.hpp"
#include "report/pareto_picture.hpp"
#include "report/region_picture.hpp"
#include "report/study_picture.hpp"

// The numbers that a picture shows, read from what gnuplot is given.
namespace sandgraph::report {
namespace {

using Table = std::vector<std::vector<double>>;

// Lines of numbers; what is no number ends a line.
Table numbers(const std::string& text) {
    Table out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        out.emplace_back();
        for (double value; cells >> value;) out.back().push_back(value);
    }
    return out;
}

const std::string& file(const Plot& plot, const std::string& name) {
    for (const auto& [its, contents] : plot.data)
        if (its == name) return contents;
    ADD_FAILURE() << "no data " << name;
    return plot.script;
}

bool says(const Plot& plot, const std::string& words) { return plot.script.find(words) != std::string::npos; }

LoadCurve curve(double scale = 1) {
    LoadCurve c{"dense", {}, {}, 2000, {results::BreakoutKind::zero_slope, 0.02, 6000 * scale}};
    for (int k = 0; k <= 40; ++k) c.d_over_B.push_back(0.0013 * k), c.load.push_back(scale * 150 * k);
    return c;
}

TEST(LoadPlot, ShowsEveryPointOfFewCurvesInUnitsOfTheOverburden) {
    const Table rows = numbers(file(load_plot({"t", {curve()}, {}}), "curve0.txt"));
    ASSERT_EQ(rows.size(), 41u);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_NEAR(rows[k][0], 0.0013 * double(k), 1e-9);
        EXPECT_NEAR(rows[k][1], 0.075 * double(k), 1e-9);
    }
}

TEST(LoadPlot, ShowsTheCorrectionAndTheBandOfAnAuditedLoad) {
    LoadCurve audited = curve();
    for (const double load : audited.load)
        audited.corrected.push_back(load - 100), audited.low.push_back(load - 300),
            audited.high.push_back(load + 100);
    const Plot plot = load_plot({"t", {audited}, {}});
    const Table rows = numbers(file(plot, "curve0.txt"));
    ASSERT_EQ(rows.at(40).size(), 5u);
    EXPECT_NEAR(rows[40][2], 2.95, 1e-9);
    EXPECT_NEAR(rows[40][3], 2.85, 1e-9);
    EXPECT_NEAR(rows[40][4], 3.05, 1e-9);
    EXPECT_TRUE(says(plot, "filledcurves"));
    EXPECT_FALSE(says(load_plot({"t", {curve()}, {}}), "filledcurves"));
}

TEST(LoadPlot, ShowsEveryPointOfManyCurves) {
    const Table rows =
        numbers(file(load_plot({"t", {curve(), curve(2), curve(3), curve(4)}, {}}), "curve1.txt"));
    ASSERT_EQ(rows.size(), 41u);
    EXPECT_NEAR(rows[13][1], 2 * 0.075 * 13, 1e-9);
}

TEST(LoadPlot, TellsTheBreakoutFactorOrThatTheLoadStillRises) {
    LoadPicture picture{"t", {curve()}, {}};
    EXPECT_TRUE(says(load_plot(picture), "3.00 at d/B = 0.020"));
    EXPECT_FALSE(says(load_plot(picture), "still rising"));
    picture.curves[0].breakout.kind = results::BreakoutKind::still_rising;
    EXPECT_TRUE(says(load_plot(picture), "still rising, 3.00"));
}

TEST(LoadPlot, TheRightAxisCountsInKilonewtons) {
    EXPECT_TRUE(says(load_plot({"t", {curve()}, {}}), "y2 via y*2 inverse y/2"));
    EXPECT_TRUE(says(load_plot({"t", {curve()}, {}}), "set y2tics 1\n"));  // to 6 kN/m
}

TEST(LoadPlot, WordsStandClearOfALineThatWouldRunThroughThem) {
    LoadPicture picture{"t", {curve()}, {{"formula", 3.2}}};
    picture.curves[0].breakout.d_over_B = 0.01;
    EXPECT_TRUE(says(load_plot(picture), "at 0.01,3 left offset 1,-2.6"));  // below it
    picture.references[0].n_gamma = 3.6;
    EXPECT_TRUE(says(load_plot(picture), "at 0.01,3 left offset 1,1 "));
}

// Late words stand left of their dot, and those of a small load above it, clear of the axis.
TEST(LoadPlot, WordsStayInsideTheAxes) {
    LoadPicture picture{"t", {curve()}, {}};
    picture.curves[0].breakout.d_over_B = 0.05;
    EXPECT_TRUE(says(load_plot(picture), "at 0.05,3 right offset -1,-4"));
    picture.references = {{"formula", 40}};
    EXPECT_TRUE(says(load_plot(picture), "at 0.05,3 right offset -1,1 "));
}

TEST(BreakoutPlot, TheFormulaRunsFromOneWidthToBeyondTheDeepestPlate) {
    const Plot plot = breakout_plot({{"x", true, 30 * std::numbers::pi / 180, {2, 8}, {1.9, 4.1}}});
    const Table rows = numbers(file(plot, "formula0.txt"));
    EXPECT_EQ(rows.front()[0], 1);
    EXPECT_NEAR(rows.back()[0], 8.8, 1e-9);
    EXPECT_NEAR(rows[30][0], 4.9, 1e-9);
    EXPECT_TRUE(says(plot, "phi = 30.0 deg"));
}

TEST(ColourScale, StepsAreOneTwoOrFiveOfAPower) {
    EXPECT_DOUBLE_EQ(round_step(15, 10), 1);
    EXPECT_DOUBLE_EQ(round_step(25, 10), 2);
    EXPECT_DOUBLE_EQ(round_step(0.6, 10), 0.05);
    EXPECT_DOUBLE_EQ(round_step(900, 10), 50);
}

TEST(ColourScale, SignedRangesFollowTheLargerSide) {
    const ColourRange range = colour_range({-8, 0, 3}, ValueKind::signed_value, 1);
    EXPECT_EQ(range.low, -8);
    EXPECT_EQ(range.high, 8);
}

TEST(ColourScale, LeavesOutThreeOfTwoThousandPointsAtEachEnd) {
    std::vector<double> values;
    for (int k = 0; k < 2001; ++k) values.push_back(k < 3 ? -1e6 : k > 1997 ? 1e6 : 1 + 1e-3 * k);
    const ColourRange some = colour_range(values, ValueKind::level, 0.1);
    EXPECT_NE(beyond(some, values), "");
    EXPECT_NEAR(some.high - some.low, 2, 0.5);
    values[3] = -1e6, values[4] = -1e6;
    EXPECT_LT(colour_range(values, ValueKind::level, 0.1).low, -1e5) << "more than that are shown";
}

TEST(ColourScale, FromZeroMeansZeroOrWhatLiesBelow) {
    EXPECT_EQ(colour_range({5, 6, 7}, ValueKind::magnitude, 1).low, 0);
    EXPECT_EQ(colour_range({5, 6, 7}, ValueKind::level, 1).low, 5);
}

TEST(BiaxialPlot, ShowsPerCentAndDilationUpwards) {
    dem::BiaxialRow row;
    row.axial_strain = 0.05, row.sin_phi = 0.4, row.volumetric_strain = -0.01;
    const Plot plot = biaxial_plot({"t", {{32e3, {{row}}}}});
    EXPECT_EQ(numbers(file(plot, "mean0.txt"))[0], (std::vector<double>{5, 0.4, 1}));
    EXPECT_EQ(numbers(file(plot, "tests0.txt"))[0], (std::vector<double>{5, 0.4, 1}));
}

// One point, its square twice as wide and half as high again, moved by (0.03, 0.04).
io::Frame one_point() {
    io::Frame frame;
    frame.x = {2.45}, frame.y = {1.05};
    frame.fields = {{"F", "-", 4, {1.5, 0, 0, 1.2}}, {"displacement", "m", 2, {0.03, 0.04}}};
    return frame;
}

results::GroundView mirrored() {
    results::GroundView view;
    view.mirror = true;
    return view;
}

TEST(FieldRows, SquaresStretchWithTheirPoints) {
    const Table rows = numbers(square_rows(one_point(), {"strain", "-", false, {7}}, mirrored()));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_NEAR(rows[0][2], 1.04 * 0.05 * 1.5, 1e-9);
    EXPECT_NEAR(rows[0][3], 1.04 * 0.05 * 1.2, 1e-9);
    EXPECT_EQ(rows[1][0], -2.45);
}

// Its displacement is 0.05 m; arrows are a spacing of 30 on a picture's width long, on depth's axis.
TEST(FieldRows, ArrowsAreMirroredAndTheLongestIsASpacingLong) {
    const ArrowScale scale = arrow_scale(one_point(), mirrored(), {0, 0.05});
    EXPECT_NEAR(scale.length * 0.05, scale.spacing, 1e-12);
    EXPECT_NEAR(scale.shown, 0.1, 1e-12);
    const Table rows = numbers(arrow_rows(one_point(), mirrored(), scale));
    ASSERT_EQ(rows.size(), 2u);
    for (const double side : {1.0, -1.0}) {
        const auto& row = rows[side > 0 ? 0 : 1];
        EXPECT_NEAR(row[0], side * 2.45, 1e-9);
        EXPECT_NEAR(row[1], 5 - 1.05, 1e-9);
        EXPECT_NEAR(row[2], side * 0.6 * scale.spacing, 1e-4);
        EXPECT_NEAR(row[3], -0.8 * scale.spacing, 1e-4);
    }
}

// Two grains of 5 mm that overlap by 1 mm at 30 deg to x, one of them a cell away, in a cell of 40 mm.
PackingPicture two_grains() {
    PackingPicture picture{"t", {}, {}, std::nullopt};
    picture.packing.H = Mat2::Identity() * 0.04;
    const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    picture.packing.x = {0.01, 0.01 + 0.009 * c + 0.04}, picture.packing.y = {0.01, 0.01 + 0.009 * s - 0.08};
    picture.packing.r = {5e-3, 5e-3};
    return picture;
}

TEST(PackingPlot, DrawsGrainsInsideTheCellInMillimetres) {
    const Table rows = numbers(file(packing_plot(two_grains()), "grains.txt"));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_NEAR(rows[1][0], 10 + 9 * std::cos(std::numbers::pi / 6), 1e-3);
    EXPECT_NEAR(rows[1][1], 14.5, 1e-3);
    EXPECT_NEAR(rows[1][2], 5, 1e-9);
}

TEST(PackingPlot, BarsRunFromCentreToCentre) {
    const Table rows = numbers(file(packing_plot(two_grains()), "bars.txt"));
    ASSERT_GE(rows.size(), 4u);
    EXPECT_NEAR(std::hypot(rows[1][0] - rows[0][0], rows[1][1] - rows[0][1]), 9, 2e-3);
    EXPECT_NEAR(std::hypot(rows[2][0] - rows[1][0], rows[2][1] - rows[1][1]), 0.35 * 5, 2e-3) << "mean force";
}

TEST(PackingPlot, TellsTheFabricAndItsDirection) {
    EXPECT_TRUE(says(packing_plot(two_grains()), "F_a = 2.00, mostly 30 deg from x"));
}

TEST(ParetoPlot, EachNumberHasItsColumnInPerCent) {
    const Plot plot = pareto_plot({"t", {{"a", 3, 0.01, 0.02, 0.03, 0.004, 0.05}}});
    EXPECT_EQ(numbers(file(plot, "runs.txt"))[0], (std::vector<double>{3, 1, 2, 3, 0.4, 5}));
}

TEST(RegionPlot, CutsTheEarthPressureCoefficientAndTurnsByDegrees) {
    io::RegionSeries region{"A", 2, {{}}};
    io::RegionRow& row = region.rows[0];
    row.d_over_B = 0.1, row.K = {2, 1, 60}, row.rotation = {0.1, -0.1, 0.2}, row.q = {3e3, 2e3, 4e3};
    const Plot plot = region_plot({"t", {region}});
    EXPECT_EQ(numbers(file(plot, "p4r0.txt"))[0], (std::vector<double>{0.1, 2, 1, 5}));
    EXPECT_EQ(numbers(file(plot, "p3r0.txt"))[0], (std::vector<double>{0.1, 3, 2, 4}));
    EXPECT_NEAR(numbers(file(plot, "p5r0.txt"))[0][1], 0.1 * 180 / std::numbers::pi, 1e-4);
}

TEST(StudyPlot, KeepsCurvesInOrderOfTheirCostAndWhatALogarithmCanShow) {
    StudyPicture picture{"t", {{"p", {{"key", {{30, 0}, {200, 0.1}}}}, {50, 0.02}, {0, 0.5}, 0, 0}}};
    const Plot plot = study_plot(picture);
    EXPECT_EQ(numbers(file(plot, "panel0_0.txt")), (Table{{30, 1e-6}, {200, 0.1}}));
    EXPECT_EQ(numbers(file(plot, "panel0_peers.txt"))[0], (std::vector<double>{1, 0.5}));
}

TEST(StudyPicture, CurvesGoFromFewToManySteps) {
    const auto settings = laboratory::study_settings(true);
    std::vector<std::vector<laboratory::StudyRun>> runs;
    for (std::size_t k = 0; k < settings.size(); ++k)
        runs.push_back({{{Stress{-1, -1, 0}}, 1000 - 7 * std::int64_t(k), 1, 0, 0}});
    const StudyPicture picture =
        study_picture(laboratory::study_rows(laboratory::biaxial_history(5e-6), settings, runs), 1);
    for (const StudyCurve& c : picture.panels.at(0).curves)
        EXPECT_TRUE(std::ranges::is_sorted(c.marks, {}, &StudyMark::dem_steps)) << c.label;
}

}  // namespace
}  // namespace sandgraph::report
