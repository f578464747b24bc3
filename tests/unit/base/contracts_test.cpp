// Contracts are checked in this file whatever the build.
#undef SANDGRAPH_CONTRACTS
#define SANDGRAPH_CONTRACTS 1
#include "base/contracts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace sandgraph {
namespace {

double root(double x) {
    SG_EXPECT(x >= 0);
    const double y = x < 4 ? x : -1;
    SG_ENSURE(std::max({y, -1.0}) == y);  // a condition may hold commas
    SG_ENSURE(y >= 0);
    return y;
}

TEST(Contract, ThatHoldsCostsNothingButItsCheck) { EXPECT_EQ(root(2), 2); }

TEST(Contract, BrokenByTheCallerNamesFileLineAndCondition) {
    EXPECT_DEATH(root(-1), "contracts_test\\.cpp:[0-9]+: precondition broken: x >= 0");
}

TEST(Contract, BrokenByTheFunctionIsAPostcondition) {
    EXPECT_DEATH(root(9), "contracts_test\\.cpp:[0-9]+: postcondition broken: y >= 0");
}

TEST(Contract, NotANumberBreaksAComparison) { EXPECT_DEATH(root(0.0 / 0.0), "x >= 0"); }

TEST(Contract, ThatIsOffIsNotEvaluated) {
    int evaluated = 0;
    SG_CONTRACT_IGNORED(++evaluated == 0);
    EXPECT_EQ(evaluated, 0);
    SG_CONTRACT_CHECKED("precondition", ++evaluated == 1);
    EXPECT_EQ(evaluated, 1);
}

TEST(Contract, OnIndicesSeesThoseOutsideAndThoseTwice) {
    using Ids = std::vector<std::int32_t>;
    EXPECT_TRUE(all_below(Ids{0, 2, 2}, 3));
    EXPECT_FALSE(all_below(Ids{0, 3}, 3));
    EXPECT_FALSE(all_below(Ids{-1}, 3));
    EXPECT_TRUE(distinct_below(Ids{2, 0, 1}, 3));
    EXPECT_FALSE(distinct_below(Ids{2, 0, 2}, 3));
    EXPECT_FALSE(distinct_below(Ids{3}, 3));
}

}  // namespace
}  // namespace sandgraph
