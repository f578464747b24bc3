#include "laboratory/critical_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "laboratory/critical_table.hpp"
#include "tests/support/subprocess.hpp"

namespace sandgraph::laboratory {
namespace {

using app::Shell;

// q/p falls from twice its late value to it over the first half; the void ratio is e.
CriticalTest shear(const std::string& density, std::uint64_t seed, double pressure, double ratio, double e) {
    CriticalTest test{density, seed, pressure, {}};
    for (int k = 0; k <= 100; ++k) {
        dem::ShearRow row;
        row.shear_strain = 0.1 * k;
        row.stress_ratio = k < 50 ? ratio * (2 - k / 50.0) : ratio;
        row.seen.porosity = e / (1 + e);
        test.rows.push_back(row);
    }
    return test;
}

TEST(CriticalState, IsTheMeanOfTheLateHalf) {
    const CriticalState s = critical_state(shear("dense", 1, 2e4, 0.36, 0.25));
    EXPECT_NEAR(s.stress_ratio, 0.36, 1e-12);
    EXPECT_NEAR(s.void_ratio(), 0.25, 1e-12);
}

TEST(CriticalState, SpreadIsThatOfTheTestsOfOneDensityAndPressure) {
    const std::vector<CriticalTest> tests{
        shear("dense", 1, 2e4, 0.35, 0.25), shear("dense", 2, 2e4, 0.37, 0.25),
        shear("loose", 1, 2e4, 0.5, 0.25), shear("dense", 1, 8e4, 0.5, 0.25)};
    const CriticalSpread s = critical_spread(tests, "dense", 2e4);
    EXPECT_EQ(s.tests, 2);
    EXPECT_NEAR(s.mean.stress_ratio, 0.36, 1e-12);
    EXPECT_NEAR(s.deviation.stress_ratio, 0.01 * std::sqrt(2), 1e-12);
    EXPECT_EQ(critical_spread(tests, "", 2e4).tests, 3);
}

TEST(CriticalState, LineGoesThroughPointsOnALine) {
    std::vector<CriticalTest> tests;
    for (const double p : {2e3, 2e4, 2e5})
        tests.push_back(shear("dense", 1, p, 0.36, 0.27 - 0.005 * p / 100e3));
    const auto line = critical_line(tests);
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->e_0, 0.27, 1e-12);
    EXPECT_NEAR(line->slope, 0.005, 1e-12);
}

TEST(CriticalState, OnePressureGivesNoLine) {
    std::vector<CriticalTest> tests;
    for (const double e : {0.26, 0.27, 0.28}) {
        tests.push_back(shear("dense", 1, 0.7e4, 0.36, e));
        EXPECT_FALSE(critical_line(tests));
    }
    CriticalPlan plan;
    plan.pressures = {0.7e4};
    EXPECT_EQ(critical_table(tests, plan).find("critical state line"), std::string::npos);
}

TEST(RveCritical, PrintsTheLineAndLeavesTablesAndPicture) {
    const Shell shell("critical");
    const auto told = shell.run("rve critical --seeds 1 --grains 100 --strain 0.1 --pressures 20,80 -o c");
    ASSERT_EQ(told.exit_code, 0) << told.err;
    EXPECT_NE(told.out.find("critical state line: e ="), std::string::npos) << told.out;
    EXPECT_NE(shell.read("c/critical_state.csv").find("loose,1,20000,"), std::string::npos);
    EXPECT_NE(shell.read("c/curves.csv").find("dense,1,20000,0.1"), std::string::npos);
    EXPECT_EQ(shell.read("c/critical_state.png").substr(1, 3), "PNG");
}

}  // namespace
}  // namespace sandgraph::laboratory
