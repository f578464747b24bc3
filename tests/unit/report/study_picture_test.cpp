#include "report/study_picture.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace sandgraph::report
