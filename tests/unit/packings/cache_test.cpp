#include "packings/cache.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "dem/prepare/prepare.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::packings {
namespace {

constexpr int kPackings = 40;

dem::Packing packing(int k) {
    dem::Packing p = dem::random_gas({.count = 20});
    p.x[0] += 1e-9 * k;
    return p;
}

// Asks for each packing and at once again: the second time it must come from the cache, and whole.
bool fills_the_cache() {
    for (int k = 0; k < kPackings; ++k) {
        const std::string recipe = "test " + std::to_string(k);
        cached_packing(recipe, {}, [&] { return packing(k); });
        bool made = false;
        const dem::Packing again = cached_packing(recipe, {}, [&] { return made = true, packing(k); });
        if (made || again.x != packing(k).x) return false;
    }
    return true;
}

TEST(PackingCache, ServesRunsThatAreStartedTogether) {
    const test::Scratch cache;
    setenv("SANDGRAPH_CACHE", cache.path().c_str(), 1);
    std::vector<pid_t> children;
    for (int k = 0; k < 4; ++k) {
        children.push_back(fork());
        if (children.back() == 0) _exit(fills_the_cache() ? 0 : 1);
    }
    for (const pid_t child : children) {
        int status = -1;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(cache.path()))
        files += entry.path().extension() == ".h5";
    EXPECT_EQ(files, kPackings);
}

}  // namespace
}  // namespace sandgraph::packings
