#include "ranks/beginning.hpp"

#include <gtest/gtest.h>

namespace sandgraph::ranks {
namespace {

TEST(Beginning, ArrivesAsItWasSent) {
    Beginning sent;
    sent.request.scene = "s.toml", sent.request.mode = "screening",
    sent.request.set = {"a.b=1", "", "c=\"d e\""};
    sent.folder = "/out", sent.scene_hash = "0123", sent.threads = 3, sent.resume = true, sent.until = 0.4;
    const Beginning got = unpacked(packed(sent));
    EXPECT_EQ(got.request.scene, sent.request.scene);
    EXPECT_EQ(got.request.mode, sent.request.mode);
    EXPECT_EQ(got.request.set, sent.request.set);
    EXPECT_EQ(got.folder, sent.folder);
    EXPECT_EQ(got.scene_hash, sent.scene_hash);
    EXPECT_EQ(got.threads, 3);
    EXPECT_TRUE(got.resume);
    EXPECT_EQ(got.until, 0.4);
}

}  // namespace
}  // namespace sandgraph::ranks
