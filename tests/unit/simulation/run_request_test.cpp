#include "simulation/run_request.hpp"

#include <gtest/gtest.h>

namespace sandgraph::simulation {
namespace {

TEST(ResumeCommand, SaysAgainWhatTheRunWasAskedFor) {
    RunRequest request;
    request.scene = "my scene.toml", request.mode = "full", request.set = {"title=a b"}, request.threads = 2;
    EXPECT_EQ(resume_command(request, "out/x"),
              "sandgraph run 'my scene.toml' -o out/x --mode full --set 'title=a b' --threads 2 --resume");
    request.until = 0.05;
    EXPECT_NE(resume_command(request, "out/x").find(" --until 0.05 "), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::simulation
