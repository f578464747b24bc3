#include "base/hash.hpp"

#include <gtest/gtest.h>

#include <set>

namespace sandgraph {
namespace {

TEST(Hash, DoesNotDependOnHowTheBytesArrive) {
    const std::string text = "the quick brown fox jumps over the lazy dog";
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        Hasher hasher;
        hasher.add(std::as_bytes(std::span(text.data(), cut)));
        hasher.add(std::as_bytes(std::span(text.data() + cut, text.size() - cut)));
        EXPECT_EQ(hasher.value(), hash64(text));
    }
}

TEST(Hash, DiffersForEverySingleBitAndForTrailingZeros) {
    const std::string text(64, '\x5a');
    std::set<std::uint64_t> seen{hash64(text), hash64(text + '\0'), hash64(text + std::string(2, '\0'))};
    for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
        std::string flipped = text;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        seen.insert(hash64(flipped));
    }
    EXPECT_EQ(seen.size(), 3 + 8 * text.size());
}

}  // namespace
}  // namespace sandgraph
