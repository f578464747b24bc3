#include "laboratory/friction_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/support/subprocess.hpp"

namespace sandgraph::laboratory {
namespace {

using app::Shell;

constexpr double degree = std::numbers::pi / 180;

// A test whose friction rises to `peak` [rad] at 5 % and stays at half its sine from 10 % on.
std::vector<dem::BiaxialRow> biaxial(double peak) {
    std::vector<dem::BiaxialRow> rows;
    for (int k = 0; k <= 200; ++k) {
        dem::BiaxialRow row;
        row.axial_strain = 0.001 * k;
        row.sin_phi = std::sin(peak) * (k < 50 ? k / 50.0 : k < 100 ? (150.0 - k) / 100 : 0.5);
        row.p = 50e3, row.q = row.p * row.sin_phi;
        row.seen.porosity = 0.2, row.seen.anisotropy = k < 150 ? 0 : 0.3;
        rows.push_back(row);
    }
    return rows;
}

Specimen specimen(const std::string& density, std::uint64_t seed, double peak) {
    Specimen s{density, seed, 0.16, 3.8, {}};
    for (auto& test : s.tests) test = biaxial(peak);
    return s;
}

TEST(FrictionRow, TakesThePeakOfTheFirstTenPerCentAndTheMeanOfTheLastFive) {
    const FrictionRow row = friction_row(specimen("dense", 1, 30 * degree));
    for (const double peak : row.peak) EXPECT_NEAR(peak, 30 * degree, 1e-12);
    EXPECT_NEAR(row.line, 30 * degree, 1e-12);
    EXPECT_NEAR(row.late_sin_phi, 0.25, 1e-12);
    EXPECT_NEAR(row.late_porosity, 0.2, 1e-12);
    EXPECT_NEAR(row.late_anisotropy, 0.3, 1e-12);
}

TEST(Spread, OfThreeNumbersByHand) {
    std::vector<FrictionRow> rows;
    for (const double angle : {28.0, 30.0, 35.0})
        rows.push_back(friction_row(specimen("dense", 1, angle * degree)));
    const Spread s = spread(rows);
    const std::size_t line = 5;
    EXPECT_NEAR(s.mean[line], 31, 1e-9);
    EXPECT_NEAR(s.deviation[line], std::sqrt((9.0 + 1.0 + 16.0) / 2), 1e-9);
    EXPECT_NEAR(s.least[line], 28, 1e-9);
    EXPECT_NEAR(s.largest[line], 35, 1e-9);
    EXPECT_EQ(spread(std::span(rows).first(1)).deviation[line], 0);
}

TEST(FrictionCsv, HasARowForEachSpecimenAndFourForEachDensity) {
    std::vector<FrictionRow> rows;
    for (const char* density : {"dense", "loose"})
        for (const std::uint64_t seed : {1, 2}) rows.push_back(friction_row(specimen(density, seed, 0.5)));
    std::istringstream csv(friction_csv(rows));
    std::string line;
    std::size_t lines = 0, columns = 2 + kFigures.size();
    for (; std::getline(csv, line); ++lines)
        EXPECT_EQ(static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')), columns - 1) << line;
    EXPECT_EQ(lines, 1 + 4 + 2 * 4u);
}

TEST(RveTable, GivesTheSameTableAgainAndLeavesItBesideThePictures) {
    const Shell shell("table");
    const auto first = shell.run("rve table --quick --seeds 1 --grains 100 -o a");
    ASSERT_EQ(first.exit_code, 0) << first.err;
    ASSERT_EQ(shell.run("rve table --quick --seeds 1 --grains 100 -o b").exit_code, 0);
    EXPECT_EQ(shell.read("a/table1.csv"), shell.read("b/table1.csv"));
    EXPECT_NE(first.out.find("YADE 29.9 to 33.6"), std::string::npos);
    for (const char* picture : {"a/biaxial_dense.png", "a/biaxial_loose.png"})
        EXPECT_EQ(shell.read(picture).substr(1, 3), "PNG");
}

TEST(RveTable, RefusesNoSeeds) {
    const Shell shell("table_seeds");
    EXPECT_EQ(shell.run("rve table --seeds 0").exit_code, 2);
}

}  // namespace
}  // namespace sandgraph::laboratory
