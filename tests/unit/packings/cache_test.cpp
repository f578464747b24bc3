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

// Without a cache a packing is made each time; that is all.
TEST(PackingCache, ThatCannotBeReachedIsPassedOver) {
    for (const std::string& folder :
         {std::string("/tmp/") + std::string(300, 'a'), std::string("/dev/null/x")}) {
        setenv("SANDGRAPH_CACHE", folder.c_str(), 1);
        EXPECT_EQ(cached_packing("unreachable", {}, [] { return packing(1); }).x, packing(1).x) << folder;
        EXPECT_EQ(cached_numbers("unreachable", 1, [] { return std::vector<double>{3}; })[0], 3) << folder;
    }
    for (const char* name : {"SANDGRAPH_CACHE", "XDG_CACHE_HOME", "HOME"}) unsetenv(name);
    setenv("TMPDIR", "/nonexistent", 1);
    EXPECT_EQ(cached_packing("no folder at all", {}, [] { return packing(2); }).x, packing(2).x);
    unsetenv("TMPDIR");
}

}  // namespace
}  // namespace sandgraph::packings
