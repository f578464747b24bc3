#include "base/child_program.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

namespace sandgraph {
namespace {

namespace fs = std::filesystem;

class Child : public testing::Test {
  protected:
    ~Child() override { fs::remove(log_); }
    static int finish(ChildProgram& child) {
        for (;;) {
            if (const auto status = child.ended()) return *status;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    std::string said() const {
        std::string line;
        std::ifstream in(log_);
        std::getline(in, line);
        return line;
    }
    fs::path log_ = fs::path(testing::TempDir()) / ("child" + std::to_string(getpid()) + ".log");
};

TEST_F(Child, TellsItsCodeAndWritesItsLog) {
    ChildProgram child({"sh", "-c", "echo told; exit 3"}, "/", log_);
    EXPECT_EQ(finish(child), 3);
    EXPECT_EQ(child.ended(), 3);  // as often as it is asked
    EXPECT_EQ(said(), "told");
}

TEST_F(Child, ThatIsMissingSaysSo) {
    ChildProgram child({"no-such-program-anywhere"}, "/", log_);
    EXPECT_EQ(finish(child), 127);
}

TEST_F(Child, StopsWhenItIsAsked) {
    ChildProgram child({"sleep", "1000"}, "/", log_);
    EXPECT_EQ(child.ended(), std::nullopt);
    child.ask_to_stop();
    EXPECT_EQ(finish(child), 128 + SIGINT);
}

// A Ctrl-C at the terminal goes to the group of the terminal: the child must get it once, from us.
TEST_F(Child, IsInAGroupOfItsOwn) {
    ChildProgram child({"sleep", "1000"}, "/", log_);
    for (int k = 0; k < 1000 && getpgid(child.id()) == getpgid(0); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(getpgid(child.id()), child.id());
}

}  // namespace
}  // namespace sandgraph
