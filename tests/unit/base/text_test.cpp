#include "base/text.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sandgraph {
namespace {

TEST(EditDistance, CountsEveryKindOfSlipOnce) {
    EXPECT_EQ(edit_distance("width", "width"), 0);
    EXPECT_EQ(edit_distance("width", "wdth"), 1);
    EXPECT_EQ(edit_distance("width", "widdth"), 1);
    EXPECT_EQ(edit_distance("width", "wodth"), 1);
    EXPECT_EQ(edit_distance("width", "wdith"), 1);
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(EditDistance, IsSymmetric) {
    EXPECT_EQ(edit_distance("embedment", "embodiment"), edit_distance("embodiment", "embedment"));
}

TEST(NearestName, TakesTheFirstOfEquals) {
    const std::vector<std::string> known{"depth", "width", "cell"};
    EXPECT_EQ(nearest_name("widht", known), "width");
    EXPECT_EQ(nearest_name("dell", known), "cell");
    EXPECT_EQ(nearest_name("xyzuv", known), "depth");
    EXPECT_EQ(nearest_name("a", {}), "");
}

TEST(Trimmed, TakesBlanksOffBothEnds) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed("  "), "");
}

TEST(DidYouMean, IsAskedOnlyWhereTheNameMayBeASlip) {
    const std::vector<std::string> known = {"anchor", "domain", "keys", "run"};
    EXPECT_EQ(did_you_mean("anker", known, "-"), "did you mean \"anchor\"?");
    EXPECT_EQ(did_you_mean("rnu", known, "-"), "did you mean \"run\"?");
    for (const char* other : {"help", "foo", "x", ""})
        EXPECT_EQ(did_you_mean(other, known, "-"), "-") << other;
    EXPECT_EQ(did_you_mean("run", {}, "-"), "-");
}

}  // namespace
}  // namespace sandgraph
