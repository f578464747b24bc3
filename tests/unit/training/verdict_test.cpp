#include "training/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sandgraph::training {
namespace {

// Two steps of each of eight histories; those of odd ones err by `scatter` more.
std::vector<ErrorSample> samples(double error, double scatter = 0) {
    std::vector<ErrorSample> out;
    for (int k = 0; k < 16; ++k) out.push_back({k / 2, 0, error + (k / 2 % 2 ? scatter : 0), 0, 0});
    return out;
}

Comparison compared(double before, double after, double scatter = 0) {
    return compare("x", samples(before), samples(after, scatter));
}

TEST(Verdict, ComparesHistoryByHistory) {
    const Comparison c = compared(0.10, 0.05, 0.02);
    EXPECT_EQ(c.histories, 8u);
    EXPECT_NEAR(c.before, 0.10, 1e-12);
    EXPECT_NEAR(c.after, 0.06, 1e-12);
    EXPECT_NEAR(c.change, -0.04, 1e-12);
    EXPECT_NEAR(c.interval, 2 * 0.01 * std::sqrt(8.0 / 7) / std::sqrt(8.0), 1e-12);
    EXPECT_TRUE(c.better());
}

TEST(Verdict, ScatterAloneMakesNothingBetter) {
    const Comparison c = compared(0.10, 0.09, 0.019);
    EXPECT_LT(c.change, 0);
    EXPECT_FALSE(c.better());
    EXPECT_NE(verdict(c, {}, "a.h5").find("no better than a.h5"), std::string::npos);
}

TEST(Verdict, SaysWhatIsForgotten) {
    const Comparison better = compared(0.10, 0.05), worse = compared(0.05, 0.10), same = compared(0.1, 0.1);
    EXPECT_EQ(verdict(better, same, "a.h5"), "better than a.h5, and nothing is forgotten");
    EXPECT_NE(verdict(better, worse, "a.h5").find("forgotten: worse on the shipped probes"),
              std::string::npos);
    EXPECT_NE(verdict(same, worse, "a.h5").find("worse than a.h5"), std::string::npos);
    EXPECT_NE(verdict(better, {}, "a.h5").find("no shipped probes"), std::string::npos);
}

TEST(Verdict, AnAnswerThatIsNoNumberIsWhollyWrong) {
    auto after = samples(0.05);
    for (ErrorSample& s : after) s.error = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(compare("x", samples(0.1), after).worse());
}

TEST(Verdict, OfOneHistoryTellsNothing) {
    const std::vector<ErrorSample> before{{0, 0, 0.5, 0, 0}}, after{{0, 0, 0.1, 0, 0}};
    const Comparison c = compare("x", before, after);
    EXPECT_FALSE(c.better());
    EXPECT_NE(comparison_text(c).find("too few to tell"), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::training
