#include "base/byte_stream.hpp"

#include <gtest/gtest.h>

namespace sandgraph {
namespace {

TEST(ByteStream, GivesBackWhatWasPut) {
    std::vector<std::uint8_t> bytes;
    ByteWriter out(bytes);
    out.put(3.5), out.put(true), out.put(std::vector<float>{1, 2, 3}), out.put(std::vector<int>{});
    ByteReader in(bytes);
    double real = 0;
    bool flag = false;
    std::vector<float> floats;
    std::vector<int> none = {1};
    in.take(real), in.take(flag), in.take(floats), in.take(none);
    EXPECT_EQ(real, 3.5);
    EXPECT_TRUE(flag);
    EXPECT_EQ(floats, (std::vector<float>{1, 2, 3}));
    EXPECT_TRUE(none.empty());
    EXPECT_TRUE(in.empty());
}

TEST(ByteStream, NoticesThatBytesAreMissing) {
    std::vector<std::uint8_t> bytes;
    ByteWriter out(bytes);
    out.put(std::vector<double>(10, 1.0));
    for (const std::size_t kept : {std::size_t{0}, std::size_t{7}, bytes.size() - 1}) {
        ByteReader in({bytes.data(), kept});
        std::vector<double> values;
        EXPECT_THROW(in.take(values), std::runtime_error);
    }
}

}  // namespace
}  // namespace sandgraph
