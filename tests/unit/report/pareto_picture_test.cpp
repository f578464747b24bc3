#include "report/pareto_picture.hpp"

#include <gtest/gtest.h>

namespace sandgraph::report {
namespace {

// Elsewhere than in scripts gnuplot takes single quotes for part of the text.
TEST(ParetoPicture, LabelsStandInDoubleQuotesInTheData) {
    const Plot plot = pareto_plot({"study", {{"0.003:0.1", 2, 0.1, 0.1, 0.1, 0.1, 0.1}, {"a \"b\" c"}}});
    const std::string& rows = plot.data.at(0).second;
    EXPECT_NE(rows.find(" \"0.003:0.1\"\n"), std::string::npos) << rows;
    EXPECT_NE(rows.find(" \"a 'b' c\"\n"), std::string::npos) << rows;
}

}  // namespace
}  // namespace sandgraph::report
