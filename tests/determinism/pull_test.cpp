#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "graph/screening/law.hpp"
#include "memory_archive.hpp"
#include "mpm/parallel_bands.hpp"
#include "small_pull.hpp"

namespace sandgraph {
namespace {

constexpr int kSteps = 150;

using MakePull = std::unique_ptr<simulation::Simulation> (*)();

std::string digest_after(MakePull make, int steps, int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([make, steps] {
        const auto pull = make();
        for (int k = 0; k < steps; ++k) pull->step();
        return support::digest(*pull);
    });
}

class Pull : public testing::TestWithParam<MakePull> {};

TEST_P(Pull, GivesTheSameBitsAtAnyThreadCount) {
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    const std::string one = digest_after(GetParam(), kSteps, 1);
    EXPECT_EQ(one, digest_after(GetParam(), kSteps, 2));
    EXPECT_EQ(one, digest_after(GetParam(), kSteps, 4));
    EXPECT_NE(one, digest_after(GetParam(), kSteps - 1, 1));  // the digest sees what changes
}

TEST_P(Pull, GoesOnBitForBitFromItsArchive) {
    const auto whole = GetParam()(), first = GetParam()(), second = GetParam()();
    for (int k = 0; k < kSteps; ++k) whole->step();
    for (int k = 0; k < kSteps / 3; ++k) first->step();
    support::MemoryArchive archive;
    first->archive(archive);
    archive.read_from_now_on();
    second->archive(archive);
    for (int k = kSteps / 3; k < kSteps; ++k) second->step();
    EXPECT_EQ(support::digest(*whole), support::digest(*second));
}

constexpr const char* kModes[] = {"Full", "Screening", "WideFull", "Carrying"};

INSTANTIATE_TEST_SUITE_P(Modes, Pull,
                         testing::Values(support::small_pull, support::small_screening_pull,
                                         support::wide_pull, support::small_carrying_pull),
                         [](const auto& mode) { return kModes[mode.index]; });

// Else the tests above would see one thread move the ground and no task update a packing.
TEST(WidePull, IsLongEnoughForItsBandsToRunAtOnce) {
    const auto pull = support::wide_pull();
    for (int k = 0; k < kSteps; ++k) pull->step();
    const mpm::Order& order = pull->state().order;
    EXPECT_GE(order.ids.size(), mpm::serial_limit);
    EXPECT_GE(order.bands(), 6u);  // of two colours
    EXPECT_GT(order.near.size(), 0u);
    EXPECT_GT(dynamic_cast<const graph::RveLaw&>(*pull->state().law).owning(), 4u);
}

// Else the tests above would see no update that goes on in the next step.
TEST(SmallCarryingPull, CutsUpdatesShort) {
    const auto pull = support::small_carrying_pull();
    int unfinished = 0;
    for (int k = 0; k < kSteps; ++k) {
        pull->step();
        const auto& law = dynamic_cast<const graph::RveLaw&>(*pull->state().law);
        for (const graph::RveAnswer& a : law.last_answers()) unfinished += a.report.unfinished;
    }
    EXPECT_GT(unfinished, 10);
}

// Else the tests above would not see the hand-over.
TEST(SmallScreeningPull, HandsPointsOverAndBack) {
    const auto pull = support::small_screening_pull();
    for (int k = 0; k < kSteps; ++k) pull->step();
    const auto& law = dynamic_cast<const graph::ScreeningLaw&>(*pull->state().law);
    EXPECT_GT(law.modes().grain_points(), 2u);
    EXPECT_LT(law.modes().grain_points(), law.size());
    EXPECT_GT(law.screening_log()->counters.replay_steps, 0);
    EXPECT_GT(law.screening_log()->audits.size(), 1u);
    const auto back = [](const stress::Switch& s) { return s.reason == graph::Reason::critical_state; };
    EXPECT_GT(std::ranges::count_if(law.screening_log()->switches, back), 2);
}

}  // namespace
}  // namespace sandgraph
