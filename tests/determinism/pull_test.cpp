#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "memory_archive.hpp"
#include "small_pull.hpp"

namespace sandgraph {
namespace {

constexpr int kSteps = 150;

std::string digest_after(int steps, int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([steps] {
        const auto pull = support::small_pull();
        for (int k = 0; k < steps; ++k) pull->step();
        return support::digest(*pull);
    });
}

TEST(Pull, GivesTheSameBitsAtAnyThreadCount) {
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    const std::string one = digest_after(kSteps, 1);
    EXPECT_EQ(one, digest_after(kSteps, 2));
    EXPECT_EQ(one, digest_after(kSteps, 4));
    EXPECT_NE(one, digest_after(kSteps - 1, 1));  // the digest sees what changes
}

TEST(Pull, GoesOnBitForBitFromItsArchive) {
    const auto whole = support::small_pull(), first = support::small_pull(), second = support::small_pull();
    for (int k = 0; k < kSteps; ++k) whole->step();
    for (int k = 0; k < kSteps / 3; ++k) first->step();
    support::MemoryArchive archive;
    first->archive(archive);
    archive.read_from_now_on();
    second->archive(archive);
    for (int k = kSteps / 3; k < kSteps; ++k) second->step();
    EXPECT_EQ(support::digest(*whole), support::digest(*second));
}

}  // namespace
}  // namespace sandgraph
