#include "report/breakout_picture.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "results/analytic.hpp"

namespace sandgraph::report {
namespace {

std::vector<std::pair<double, double>> pairs(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::pair<double, double>> out;
    for (double a, b; in >> a >> b;) out.emplace_back(a, b);
    return out;
}

TEST(BreakoutPicture, DrawsTheFormulaThatBelongsToThePlate) {
    const double phi = 0.527;
    for (const bool horizontal : {true, false}) {
        const Plot plot = breakout_plot({{"x", horizontal, phi, {2, 8}, {1.9, 4.1}}});
        ASSERT_EQ(plot.data.size(), 2u);
        const auto measured = pairs(plot.data[0].second), formula = pairs(plot.data[1].second);
        ASSERT_EQ(measured.size(), 2u);
        EXPECT_DOUBLE_EQ(measured[1].second, 4.1);
        EXPECT_GE(formula.back().first, 8);
        for (const auto& [ratio, n] : formula)
            EXPECT_NEAR(n, horizontal ? results::meyerhof_adams(ratio, phi) : results::biarez(ratio, phi),
                        1e-4);
    }
}

TEST(BreakoutPicture, WithoutAFrictionAngleThereIsNoFormula) {
    EXPECT_EQ(breakout_plot({{"x", true, 0, {2}, {1.9}}}).data.size(), 1u);
}

}  // namespace
}  // namespace sandgraph::report
