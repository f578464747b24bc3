#include "report/sweep_page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "support/small_sweep.hpp"

namespace sandgraph::report {
namespace {

using support::SmallSweep;

constexpr const char* kTable =
    "title = \"T\"\n[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [2, 1]\n"
    "[[axis]]\nkey = \"grains.density\"\nvalues = [\"dense\", \"loose\"]\n";

TEST(SweepPicture, HasACurveForEachValueOfTheSecondAxisInOrderOfTheFirst) {
    const SmallSweep sweep("curves");
    const auto plan = sweep.plan(kTable);
    for (std::size_t k = 0; k < plan.runs.size(); ++k) sweep.finish(plan.runs[k], 1 + double(k));
    const SweepPicture picture = sweep_picture(plan, results::sweep_results(plan));
    ASSERT_EQ(picture.curves.size(), 2u);
    EXPECT_EQ(picture.axis, "anchor.embedment_ratio");
    EXPECT_EQ(picture.curves[1].label, "loose");
    ASSERT_EQ(picture.curves[1].marks.size(), 2u);
    EXPECT_EQ(picture.curves[1].marks[0].at, 1);
    EXPECT_EQ(picture.curves[1].marks[0].n_gamma, 4);
    EXPECT_EQ(picture.curves[1].marks[0].formula, 2.5);
}

TEST(SweepPicture, WordsOfTheFirstAxisArePlacesInTheirOrder) {
    const SmallSweep sweep("words");
    const auto plan = sweep.plan("[[axis]]\nkey = \"grains.density\"\nvalues = [\"loose\", \"dense\"]\n");
    const SweepPicture picture = sweep_picture(plan, results::sweep_results(plan));
    EXPECT_EQ(picture.places, (std::vector<std::string>{"loose", "dense"}));
    EXPECT_EQ(picture.curves.at(0).marks.at(1).at, 1);
    EXPECT_NE(sweep_plot(picture).script.find("set xtics ('loose' 0, 'dense' 1)"), std::string::npos);
}

TEST(SweepPicture, BarsAreTheIntervalsAndTheClosedFormIsBroken) {
    const Plot plot =
        sweep_plot({"t", "x", {}, {{"a", {{1, 2, 0.3, 2.5}, {2, NAN, NAN, NAN}, {3, 4, NAN, 5}}}}});
    ASSERT_EQ(plot.data.size(), 2u);
    EXPECT_EQ(plot.data[0].second, "1 2 0.3\n3 4 0\n");
    EXPECT_EQ(plot.data[1].second, "1 2.5\n3 5\n");
    EXPECT_NE(plot.script.find("yerrorbars"), std::string::npos);
}

TEST(SweepHistogram, HasEveryValueInOneOfItsBins) {
    std::vector<double> values;
    for (int k = 0; k < 40; ++k) values.push_back(2 + std::sin(k));
    std::istringstream in(histogram_plot({"t", values}).data.at(0).second);
    int sum = 0;
    for (double at = 0, count = 0; in >> at >> count; sum += int(count)) EXPECT_NEAR(at, 2, 1.3);
    EXPECT_EQ(sum, 40);
    EXPECT_EQ(histogram_plot({"t", {2, 2, 2}}).data.at(0).second.find(" 3\n") == std::string::npos, false);
}

TEST(SweepPage, LinksRowsToTheirRunsAndLoadsNothing) {
    const SmallSweep sweep("page");
    const auto plan = sweep.plan(kTable);
    sweep.finish(plan.runs[0], 2);
    std::filesystem::create_directories(plan.folder);
    write_sweep_page(plan, results::sweep_results(plan));
    std::ifstream in(plan.folder / "index.html");
    const std::string html = (std::ostringstream() << in.rdbuf()).str();
    EXPECT_NE(html.find("<h1>T</h1>"), std::string::npos);
    EXPECT_NE(html.find("href=\"#embedment_ratio%3D2_density%3Ddense\""), std::string::npos);
    EXPECT_NE(html.find("href=\"rows/embedment_ratio=2_density=dense/1/\""), std::string::npos);
    EXPECT_NE(html.find("sample 1: coarse"), std::string::npos);
    EXPECT_EQ(html.find("src=\"http"), std::string::npos);
    EXPECT_EQ(html.find("<link"), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::report
