#include "ranks/rank_pool.hpp"

#include <gtest/gtest.h>

#include "small_pull.hpp"
#include "tests/support/memory_archive.hpp"
#include "tests/support/thread_team.hpp"

namespace sandgraph::ranks {
namespace {

using support::SmallPull;
constexpr int kSteps = 150;

struct Member {
    explicit Member(Team& team, SmallPull kind) {
        simulation =
            support::small_pull_in(kind, [&](const auto& initial, const auto& material, const auto& options) {
                auto made = std::make_unique<RankPool>(team, initial, material, options);
                pool = made.get();
                return made;
            });
    }
    // Rank 0 may look after the last of them only.
    void step(int count) {
        for (int k = 0; k < count; ++k) {
            pool->announce(k + 1 == count);
            simulation->step();
        }
    }
    void serve() { EXPECT_THROW(pool->serve(), Dismissed); }
    std::unique_ptr<simulation::Simulation> simulation;
    RankPool* pool = nullptr;
};

std::string alone(SmallPull kind) {
    const auto pull = support::small_pull_in(kind, graph::local_pool);
    for (int k = 0; k < kSteps; ++k) pull->step();
    return support::digest(*pull);
}

std::string packings_of(const simulation::Simulation& pull) {
    std::string out;
    for (std::size_t p = 0; p < pull.state().points.size(); ++p)
        if (const dem::Rve* rve = pull.state().law->observe(p).packing) {
            Bytes bytes;
            ByteWriter writer(bytes);
            rve->save(writer);
            out.append(bytes.begin(), bytes.end());
        }
    return out;
}

class RanksOfThreads : public testing::TestWithParam<std::tuple<SmallPull, int>> {
  protected:
    SmallPull kind() const { return std::get<0>(GetParam()); }
    int ranks() const { return std::get<1>(GetParam()); }
};

TEST_P(RanksOfThreads, ComeToTheBitsOfOneProcess) {
    std::vector<std::string> digests(static_cast<std::size_t>(ranks()));
    support::ThreadRanks(ranks()).run([&](Team& team) {
        Member member(team, kind());
        member.step(kSteps);
        digests[static_cast<std::size_t>(team.rank())] = support::digest(*member.simulation);
        if (team.rank() > 0) return member.serve();
        tell(team, {});
    });
    const std::string one = alone(kind());
    for (const std::string& digest : digests) EXPECT_EQ(digest, one);
}

TEST_P(RanksOfThreads, ShowEveryPackingToRank0) {
    const auto pull = support::small_pull_in(kind(), graph::local_pool);
    for (int k = 0; k < kSteps; ++k) pull->step();
    support::ThreadRanks(ranks()).run([&](Team& team) {
        Member member(team, kind());
        member.step(kSteps);
        if (team.rank() > 0) return member.serve();
        EXPECT_EQ(packings_of(*member.simulation), packings_of(*pull));
        EXPECT_EQ(member.simulation->state().law->grain_use().active, pull->state().law->grain_use().active);
        tell(team, {});
    });
}

// What a checkpoint holds does not tell how many ranks there were; any number goes on from it.
TEST_P(RanksOfThreads, GoOnFromTheCheckpointOfAnyNumber) {
    const auto first = support::small_pull_in(kind(), graph::local_pool);
    for (int k = 0; k < kSteps / 3; ++k) first->step();
    support::MemoryArchive alone_archive, shared_archive;
    first->archive(alone_archive);
    support::ThreadRanks(ranks()).run([&](Team& team) {
        Member member(team, kind());
        member.step(kSteps / 3);
        if (team.rank() > 0) return member.serve();
        member.simulation->archive(shared_archive);
        tell(team, {});
    });
    // The log of a screening run has gaps between its numbers, which hold anything.
    if (kind() != SmallPull::screening) EXPECT_TRUE(shared_archive.same_as(alone_archive));
    shared_archive.read_from_now_on();
    const std::string one = alone(kind());
    const int other = ranks() % 4 + 1;
    support::ThreadRanks(other).run([&](Team& team) {
        Member member(team, kind());
        support::MemoryArchive archive = shared_archive;
        member.simulation->archive(archive);
        member.step(kSteps - kSteps / 3);
        if (team.rank() > 0) return member.serve();
        EXPECT_EQ(support::digest(*member.simulation), one);
        tell(team, {});
    });
}

INSTANTIATE_TEST_SUITE_P(Pools, RanksOfThreads,
                         testing::Combine(testing::Values(SmallPull::full, SmallPull::carrying,
                                                          SmallPull::screening),
                                          testing::Values(1, 2, 3, 4)));

TEST(RankPool, MovesPackingsToWhereThereIsLessWork) {
    support::ThreadRanks(3).run([&](Team& team) {
        Member member(team, SmallPull::full);
        member.step(450);
        if (team.rank() > 0) return member.serve();
        EXPECT_GT(member.pool->figures().moved, 0);
        EXPECT_LT(member.pool->figures().waits, 100);
        tell(team, {});
    });
}

TEST(RankPool, RefusesALookThatWasNotAnnounced) {
    support::ThreadRanks(2).run([&](Team& team) {
        Member member(team, SmallPull::full);
        while (member.pool->figures().exchanges == 0) member.pool->announce(false), member.simulation->step();
        if (team.rank() > 0) return;
        EXPECT_THROW(member.pool->rve(1), std::logic_error);
    });
}

}  // namespace
}  // namespace sandgraph::ranks
