#include <gtest/gtest.h>

#include "report/pareto_picture.hpp"
#include "report/study_picture.hpp"

namespace sandgraph::report {
namespace {

// Marks of every setting, with no run behind them.
std::vector<laboratory::StudyRow> some_rows() {
    const auto settings = laboratory::study_settings(true);
    const std::vector<std::vector<laboratory::StudyRun>> runs(settings.size(),
                                                              {{{Stress{-1, -1, 0}}, 10, 1, 0, 0}});
    return laboratory::study_rows(laboratory::biaxial_history(5e-6), settings, runs);
}

TEST(StudyPicture, HasOnePanelAHistoryAndACurveAKeyWithTheDefaultOnEach) {
    const StudyPicture picture = study_picture(some_rows(), 1);
    ASSERT_EQ(picture.panels.size(), 1u);
    EXPECT_EQ(picture.panels[0].curves.size(), 9u);  // eight keys, and several moved together
    for (const StudyCurve& curve : picture.panels[0].curves) EXPECT_GE(curve.marks.size(), 3u) << curve.label;
}

// Elsewhere than in scripts gnuplot takes single quotes for part of the text.
TEST(ParetoPicture, LabelsStandInDoubleQuotesInTheData) {
    const Plot plot = pareto_plot({"study", {{"0.003:0.1", 2, 0.1, 0.1, 0.1, 0.1, 0.1}, {"a \"b\" c"}}});
    const std::string& rows = plot.data.at(0).second;
    EXPECT_NE(rows.find(" \"0.003:0.1\"\n"), std::string::npos) << rows;
    EXPECT_NE(rows.find(" \"a 'b' c\"\n"), std::string::npos) << rows;
}

}  // namespace
}  // namespace sandgraph::report
