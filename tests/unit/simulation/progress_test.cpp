#include "simulation/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace sandgraph::simulation {
namespace {

ProgressState at(double mark) {
    return {.step = 10, .mark = mark, .target = 0.4, .load = 12345, .rve_active = 7};
}

TEST(ProgressLine, CountsTimeWithoutAnAnchor) {
    const ProgressState settling{.step = 10, .mark = 0.5, .target = 1, .rve_active = 7, .anchored = false};
    EXPECT_EQ(progress_line(settling, 4.0), "step 10  0.5000 of 1 s  RVEs 7  4 s left");
}

TEST(ProgressLine, SaysWhereTheRunStands) {
    EXPECT_EQ(progress_line(at(0.01), 250.0),
              "step 10  d/B 0.0100 of 0.4  load 12.3 kN/m  RVEs 7  4 min 10 s left");
    EXPECT_EQ(progress_line(at(0.01), std::nullopt), "step 10  d/B 0.0100 of 0.4  load 12.3 kN/m  RVEs 7");
}

TEST(TimeLeft, IsUnknownUntilThePlateMoves) {
    TimeLeft left;
    EXPECT_FALSE(left.update(at(0), 0));
    EXPECT_FALSE(left.update(at(0), 5));
    EXPECT_TRUE(left.update(at(0.1), 6));
}

TEST(TimeLeft, IsExactAtConstantSpeed) {
    TimeLeft left;
    for (int t = 0; t < 10; ++t) left.update(at(0.01 * t), t);
    EXPECT_NEAR(*left.update(at(0.1), 10), 30, 1e-9);
}

TEST(TimeLeft, FollowsAChangeOfSpeed) {
    TimeLeft left;
    for (int t = 0; t < 10; ++t) left.update(at(0.01 * t), t);
    double seconds = 0;
    for (int t = 10; t < 210; ++t) seconds = *left.update(at(0.09 + 0.001 * (t - 9)), t);
    EXPECT_NEAR(seconds, (0.4 - 0.29) / 0.001, 1);
}

// What a file (no terminal) gets from updates at the given times.
std::string written(const std::vector<double>& times) {
    std::FILE* file = std::tmpfile();
    {
        Progress progress(file);
        for (const double time : times) progress.update(at(0.1), time);
    }
    std::rewind(file);
    std::string all;
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) all += static_cast<char>(c);
    std::fclose(file);
    return all;
}

TEST(Progress, IsPlainAndRareWithoutATerminal) {
    const std::string text = written({0, 1, 5, 9.9, 10, 12, 25});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_EQ(text.find('\033'), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::simulation
