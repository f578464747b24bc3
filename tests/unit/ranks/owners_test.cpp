#include "ranks/owners.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sandgraph::ranks {
namespace {

TEST(Owners, DealNeighboursToDifferentRanks) {
    const Owners owners(7, 3);
    for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(owners.of(k), int(k % 3));
}

TEST(Owners, MoveNothingBeforeAnythingIsMeasured) {
    Owners owners(8, 4);
    EXPECT_TRUE(owners.balance().empty());
    EXPECT_EQ(owners.imbalance(), 1);
}

TEST(Owners, LeaveASmallGapAlone) {
    Owners owners(4, 2);
    for (std::size_t k = 0; k < 4; ++k) owners.measure(k, k % 2 == 0 ? 104 : 100);
    EXPECT_LT(owners.imbalance(), Owners::tolerated);
    EXPECT_TRUE(owners.balance().empty());
}

TEST(Owners, NarrowALargeGap) {
    Owners owners(100, 2);
    for (std::size_t k = 0; k < 100; k += 2) owners.measure(k, 10 + std::int64_t(k));  // all of rank 0
    const auto moves = owners.balance();
    EXPECT_LT(owners.imbalance(), Owners::settled);
    EXPECT_FALSE(moves.empty());
    for (const Owners::Move& m : moves) {
        EXPECT_EQ(m.from, 0);
        EXPECT_EQ(m.to, 1);
        EXPECT_EQ(owners.of(m.packing), 1);
    }
}

// One packing cannot be cut in two, and moving it would only turn the gap round.
TEST(Owners, KeepOnePackingThatTakesAllTheTime) {
    Owners owners(4, 2);
    owners.measure(2, 1'000'000);
    EXPECT_TRUE(owners.balance().empty());
    owners.measure(1, 10);
    EXPECT_TRUE(owners.balance().empty());
}

// Whoever measures the same comes to the same table: no clock, no order of threads.
TEST(Owners, AgreeOnAllRanks) {
    const auto table = [] {
        Owners owners(500, 7);
        std::vector<Owners::Move> moves;
        for (int round = 0; round < 20; ++round) {
            for (std::size_t k = 0; k < 500; ++k)
                owners.measure(k, std::int64_t(k * k * std::size_t(round + 1)) % 977);
            for (const auto& m : owners.balance()) moves.push_back(m);
        }
        return moves;
    };
    const auto first = table();
    EXPECT_EQ(first, table());
    EXPECT_GT(first.size(), 10u);
}

// Hysteresis: once even, costs that waver by a few per cent move nothing any more.
TEST(Owners, ComeToRestUnderWaveringCosts) {
    Owners owners(400, 4);
    std::size_t late = 0;
    for (int round = 0; round < 40; ++round) {
        for (std::size_t k = 0; k < 400; ++k) {
            const auto wavers = std::int64_t((k * 7919 + std::size_t(round) * 104729) % 21);
            owners.measure(k, (k < 100 ? 1000 : 50) + wavers);
        }
        const std::size_t moved = owners.balance().size();
        if (round >= 5) late += moved;
    }
    EXPECT_EQ(late, 0u);
    EXPECT_LT(owners.imbalance(), Owners::tolerated);
}

TEST(Owners, ForgetWhatWasLongAgo) {
    Owners owners(4, 2);
    owners.measure(0, 1000), owners.measure(2, 1000);
    for (int k = 0; k < 12; ++k) owners.balance();
    EXPECT_EQ(owners.imbalance(), 1);
}

}  // namespace
}  // namespace sandgraph::ranks
