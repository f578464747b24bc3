#include "tests/unit/scene/refused.hpp"

namespace sandgraph::scene {
namespace {

std::string ground(const std::string& length) {
    return refused("[ground]\ninternal_length = \"" + length + "\"\n");
}

TEST(InternalLength, IsACellOrMore) {
    EXPECT_EQ(ground("0.1 m"), "accepted");
    EXPECT_EQ(ground("0 m"), "accepted");
    EXPECT_EQ(ground("0.09 m"),
              "s.toml:2: ground.internal_length = \"0.09 m\" (below cell = 0.1 m, which no band can be "
              "narrower than); write \"0.2 m\" or more, or 0");
}

TEST(InternalLength, IsATenthOfTheDomainOrLess) {
    EXPECT_EQ(ground("0.5 m"), "accepted");
    EXPECT_EQ(ground("0.51 m"),
              "s.toml:2: ground.internal_length = \"0.51 m\" (more than a tenth of the domain: no band, but "
              "all of the ground); write \"0.5 m\" or less");
}

TEST(InternalLength, IsNotNegative) { EXPECT_NE(ground("-0.1 m"), "accepted"); }

}  // namespace
}  // namespace sandgraph::scene
