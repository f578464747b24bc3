#include "packings/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace sandgraph::packings {
namespace {

scene::Grains grains(int samples, std::uint64_t seed = 1) {
    scene::Grains g;
    g.samples = samples, g.seed = seed;
    return g;
}

// Twenty points a row, as they are laid out.
std::vector<std::int32_t> rows(int count) {
    std::vector<std::int32_t> out;
    for (int row = count - 1; row >= 0; --row) out.insert(out.end(), 20, row);
    return out;
}

TEST(SampleSeed, OfTheFirstIsTheRecipesOwn) {
    EXPECT_EQ(sample_seed(7, 0), 7u);
    EXPECT_EQ(sample_recipe(grains(4, 7), 0).seed, 7u);
    EXPECT_EQ(sample_recipe(grains(4, 7), 3).samples, 1);
}

TEST(SampleSeed, AreAllDifferentForNeighbouringSeedsAndFitALog) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        for (int sample = 0; sample < 16; ++sample) seen.insert(sample_seed(seed, sample));
    EXPECT_EQ(seen.size(), 320u);
    EXPECT_GE(static_cast<std::int64_t>(*seen.rbegin()), 0);
}

TEST(Deal, OneSampleIsOnePackingARow) { EXPECT_EQ(deal(rows(3), grains(1)), rows(3)); }

TEST(Deal, GivesEveryRowAllSamplesEvenly) {
    const auto row = rows(5);
    for (const int samples : {2, 4, 16, 30}) {
        const auto dealt = deal(row, grains(samples));
        for (int r = 0; r < 5; ++r)
            for (int sample = 0; sample < samples; ++sample) {
                const auto share = std::ranges::count(dealt, r * samples + sample);
                EXPECT_GE(share, 20 / samples) << samples;
                EXPECT_LE(share, (20 + samples - 1) / samples) << samples;
            }
        for (std::size_t p = 0; p < row.size(); ++p) EXPECT_EQ(dealt[p] / samples, row[p]);
    }
}

TEST(Deal, BringsNoSampleTwiceBeforeEachCameOnce) {
    const auto dealt = deal(rows(1), grains(5));
    for (std::size_t begin = 0; begin < 20; begin += 5)
        EXPECT_EQ(std::set(dealt.begin() + begin, dealt.begin() + begin + 5).size(), 5u);
}

TEST(Deal, HangsOnTheSeedAndNothingElse) {
    EXPECT_EQ(deal(rows(4), grains(4, 3)), deal(rows(4), grains(4, 3)));
    EXPECT_NE(deal(rows(4), grains(4, 3)), deal(rows(4), grains(4, 4)));
    // Rows differ: no column of points gets one packing all the way down.
    const auto dealt = deal(rows(2), grains(4, 3));
    bool differ = false;
    for (std::size_t k = 0; k < 20; ++k) differ = differ || dealt[k] % 4 != dealt[20 + k] % 4;
    EXPECT_TRUE(differ);
}

}  // namespace
}  // namespace sandgraph::packings
