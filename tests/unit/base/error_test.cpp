#include "base/error.hpp"

#include <gtest/gtest.h>

namespace sandgraph {
namespace {

TEST(InputError, TellsEverythingInOneLine) {
    EXPECT_STREQ(InputError({"a.toml", 3}, "b = 1", "why", "do this").what(),
                 "a.toml:3: b = 1 (why); do this");
    EXPECT_STREQ(InputError({"a.h5", 0}, "broken", "", "").what(), "a.h5: broken");
}

TEST(InputError, NeverBreaksTheLine) {
    const InputError error({"a\nb", 1}, "two\nlines", "why\r\n", "do\nthis");
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find('\r'), std::string::npos);
}

}  // namespace
}  // namespace sandgraph
