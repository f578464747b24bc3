#include "results/budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "results/budget_study.hpp"
#include "support/paths.hpp"

// What a budget says of a load, of loads whose errors are known.
namespace sandgraph::results {
namespace {

const BudgetItem& item(const std::vector<BudgetItem>& items, const std::string& source) {
    for (const BudgetItem& i : items)
        if (i.source == source) return i;
    ADD_FAILURE() << source;
    return items.front();
}
bool has(const std::vector<BudgetItem>& items, const std::string& source) {
    return std::ranges::any_of(items, [&](const BudgetItem& i) { return i.source == source; });
}

// Exactly 100, one per cent too much for each tenth of a metre of cell, on cells of 0.1 and 0.2 m.
TEST(BudgetItems, TakeOffAnErrorThatGoesWithTheCell) {
    const auto items = budget_items({.fine = 101, .coarse = {102}}, 0, NAN);
    EXPECT_NEAR(101 * (1 + item(items, "mesh").correction), 100, 0.02);
    EXPECT_GE(item(items, "mesh").ci95, 0.025) << "two grids miss exact plates by as much";
    EXPECT_FALSE(has(items, "packings")) << "closed-form ground has none";
    EXPECT_FALSE(has(items, "surrogate"));
}

TEST(BudgetItems, MoveOnePackingToTheMeanOfSeveral) {
    const auto items = budget_items({.fine = 100, .coarse = {104, 100, 96, 100}}, 0, NAN);
    EXPECT_NEAR(item(items, "packings").correction, 100.0 / 104 - 1, 1e-12);
    const double deviation = std::sqrt(32.0 / 3) / 100;
    EXPECT_NEAR(item(items, "packings").ci95, 3.182446 * deviation / 2, 1e-4) << "Student, three degrees";
}

// A load that rises with the rate by 4 %, half of which half the rate leaves out.
TEST(BudgetItems, BelieveTheToldDragAsFarAsHalfTheRateBearsItOut) {
    const auto right = budget_items({.fine = 104, .coarse = {104}, .slow = 102}, 0.0385, NAN);
    EXPECT_NEAR(item(right, "rate").correction, -0.0385, 1e-12);
    EXPECT_LT(item(right, "rate").ci95, 0.01);
    const auto wrong = budget_items({.fine = 104, .coarse = {104}, .slow = 102}, 0.0, NAN);
    EXPECT_GT(item(wrong, "rate").ci95, 0.019) << "told nothing, seen 3.8 %";
}

TEST(BudgetItems, HoldTheSurrogateAgainstTheGrains) {
    const auto items = budget_items({.fine = 100, .coarse = {100, 102}, .grains = 103}, 0, NAN);
    EXPECT_NEAR(item(items, "surrogate").correction, 0.03, 1e-12);
    EXPECT_NEAR(item(items, "surrogate").ci95, 0.015, 1e-12);
}

TEST(BudgetItems, TakeTheBookWhereNoSecondGridHoldsTheScene) {
    EXPECT_NEAR(item(budget_items({}, 0, 0.04), "mesh").correction, -0.04, 1e-12);
    const auto nothing = budget_items({}, 0, NAN);
    EXPECT_TRUE(std::isnan(item(nothing, "mesh").ci95)) << "not known is said, not taken for none";
    EXPECT_NE(item(nothing, "mesh").how.find("not known"), std::string::npos);
}

TEST(Budget, MultipliesCorrectionsAndAddsIntervalsInSquares) {
    Budget b;
    b.load = 100e3, b.unit_load = 50e3;
    b.items = {{"packings", 0.02, 0.03, ""}, {"mesh", -0.01, 0.04, ""}, {"rate", 0, NAN, ""}};
    EXPECT_NEAR(b.corrected(), 100e3 * 1.02 * 0.99, 1e-6);
    EXPECT_NEAR(b.ci95(), 0.05 * b.corrected(), 1e-6);
    EXPECT_NE(to_json(b).find("\"ci95\": null"), std::string::npos);
}

simulation::RunRequest scene_at(const char* file, std::vector<std::string> set = {}) {
    simulation::RunRequest request;
    request.scene = test::source_file(file), request.set = std::move(set);
    return request;
}

TEST(SharedGeometry, IsHeldByBothGrids) {
    for (const char* file :
         {"/configs/quick.toml", "/configs/anchor_horizontal.toml", "/configs/anchor_vertical.toml"}) {
        const auto set = shared_geometry(scene_at(file));
        ASSERT_TRUE(set) << file;
        EXPECT_FALSE(set->empty()) << file << ": its plate is a cell thick";
    }
}

TEST(SharedGeometry, OfASceneThatBothGridsHoldIsItsOwn) {
    const auto set = shared_geometry(scene_at("/configs/exact/anchor.toml"));
    ASSERT_TRUE(set);
    for (const std::string& s : *set) ADD_FAILURE() << s;
}

TEST(SharedGeometry, IsNoneWhereTheFacesFitNoSecondGrid) {
    EXPECT_FALSE(shared_geometry(scene_at("/configs/quick.toml", {"anchor.embedment_ratio=2.125"})));
}

}  // namespace
}  // namespace sandgraph::results
