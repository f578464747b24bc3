#include "training/split.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace sandgraph::training {
namespace {

void add(HistorySet& set, Origin origin, std::int64_t seed, int histories) {
    io::HistoryPacking packing;
    packing.seed = seed;
    set.packings.push_back(packing);
    for (int k = 0; k < histories; ++k) {
        History history;
        history.origin = origin;
        history.packing = static_cast<std::int32_t>(set.packings.size()) - 1;
        history.F_inc.resize(20, Mat2::Identity()), history.stress.resize(20);
        set.histories.push_back(history);
    }
}

HistorySet probes(int seeds) {
    HistorySet set;
    for (int seed = 1; seed <= seeds; ++seed) add(set, Origin::probe, seed, 20);
    return set;
}

TEST(Split, OneRunSufficesByItsPoints) {
    for (const int points : {3, 5, 12, 100}) {
        HistorySet set;
        add(set, Origin::run, 7, points);
        const Split s = split(set, {});
        EXPECT_TRUE(s.new_seeds.empty());
        EXPECT_GE(s.known_seeds.size(), 1u) << points;
        EXPECT_GE(s.validation.size(), 1u) << points;
        EXPECT_GE(s.training.size(), 1u) << points;
        EXPECT_EQ(s.training.size() + s.validation.size() + s.known_seeds.size(),
                  static_cast<std::size_t>(points));
    }
    HistorySet two;
    add(two, Origin::run, 7, 2);
    EXPECT_THROW(split(two, {}), InputError);
}

TEST(Split, NeverHoldsOutTheSeedOfARunUnasked) {
    HistorySet set = probes(4);
    add(set, Origin::run, 12, 20);  // the highest
    add(set, Origin::run, 4, 20);   // and one that the probes have, too
    const Split s = split(set, {});
    EXPECT_EQ(s.seeds_held_out, std::vector<std::int64_t>{3});
    EXPECT_EQ(s.seeds_validation, std::vector<std::int64_t>{2});
    for (const std::int64_t k : s.new_seeds) EXPECT_EQ(set.start_of(set.histories[k]).seed, 3);
}

TEST(Split, HoldsOutSeedsOfRunsWhereTheRecipeAsks) {
    HistorySet set;
    for (int seed = 1; seed <= 3; ++seed) add(set, Origin::run, seed, 20);
    EXPECT_TRUE(split(set, {}).seeds_held_out.empty());
    scene::TrainSpec asked;
    asked.seeds_asked = true;
    EXPECT_EQ(split(set, asked).seeds_held_out, std::vector<std::int64_t>{3});
    asked.held_out_seeds = 3;
    EXPECT_THROW(split(set, asked), InputError);
}

TEST(Split, ProbesKeepWholeSeedsApart) {
    const HistorySet set = probes(6);
    const Split s = split(set, {});
    EXPECT_EQ(s.seeds_held_out, std::vector<std::int64_t>{6});
    EXPECT_EQ(s.seeds_validation, std::vector<std::int64_t>{5});
    EXPECT_EQ(s.new_seeds.size(), 20u);
    EXPECT_EQ(s.known_seeds.size(), 8u);
    EXPECT_EQ(s.training.size(), 72u);
}

TEST(Split, NothingIsTrainedOnTheGuard) {
    HistorySet set;
    add(set, Origin::run, 7, 12);
    add(set, Origin::guard, 101, 9);
    const Split s = split(set, {});
    EXPECT_EQ(s.guard_validation.size(), 5u);
    EXPECT_EQ(s.guard.size(), 4u);
    for (const auto* part : {&s.training, &s.validation, &s.known_seeds, &s.new_seeds})
        for (const std::int64_t k : *part) EXPECT_NE(set.histories[k].origin, Origin::guard);
}

}  // namespace
}  // namespace sandgraph::training
