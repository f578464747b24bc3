#include "base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sandgraph {
namespace {

TEST(Random, DependsOnSeedAndStreamOnly) {
    Random a(1, 7), b(1, 7), other_stream(1, 8), other_seed(2, 7);
    const std::uint64_t first = a.bits();
    EXPECT_EQ(first, b.bits());
    EXPECT_NE(first, other_stream.bits());
    EXPECT_NE(first, other_seed.bits());
}

TEST(Random, IsUniformInTheUnitInterval) {
    Random random(3);
    double sum = 0, squares = 0;
    const int n = 100000;
    for (int i = 0; i < n; ++i) {
        const double u = random.uniform();
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        sum += u, squares += u * u;
    }
    EXPECT_NEAR(sum / n, 0.5, 5 * 0.2887 / std::sqrt(n));
    EXPECT_NEAR(squares / n, 1.0 / 3, 5 * 0.2981 / std::sqrt(n));
}

}  // namespace
}  // namespace sandgraph
