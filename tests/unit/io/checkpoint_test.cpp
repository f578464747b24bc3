#include "io/checkpoint.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "base/error.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

namespace fs = std::filesystem;
using test::Scratch;

struct State {
    std::vector<double> x{0.1, -0.0, 3};
    std::vector<std::int64_t> id{1, -2};
    std::vector<std::uint8_t> flags;
    friend bool operator==(const State&, const State&) = default;
};

void archive(Archive& a, State& s) {
    a.field("points/x", s.x);
    a.field("points/id", s.id);
    a.field("flags", s.flags);
}

void save(const fs::path& path, State state, const std::string& hash = "abc") {
    CheckpointWriter writer(path, {hash, "v1", state.x.front()});
    archive(writer, state);
    writer.commit();
}

State load(const fs::path& path, std::string* notice = nullptr) {
    CheckpointReader reader(path, "abc");
    if (notice) *notice = reader.notice();
    State state{{}, {}, {9}};
    archive(reader, state);
    return state;
}

State numbered(double n) { return {std::vector<double>(2000, n), {7}, {1, 2}}; }

TEST(Checkpoint, ReadsBackTheSameBits) {
    const Scratch folder;
    const fs::path path = folder / "checkpoint.h5";
    save(path, State{});
    const State state = load(path);
    EXPECT_EQ(state, State{});
    EXPECT_TRUE(std::signbit(state.x[1]));
    for (const auto& entry : fs::directory_iterator(folder.path())) EXPECT_EQ(entry.path(), path);
    CheckpointReader reader(path, "abc");
    EXPECT_EQ(reader.header().git, "v1");
    EXPECT_EQ(reader.header().d_over_B, 0.1);
}

TEST(Checkpoint, AnyFlippedByteFallsBackToThePreviousOne) {
    const Scratch folder;
    const fs::path path = folder / "checkpoint.h5";
    save(path, numbered(1));
    save(path, numbered(2));
    const std::string whole = test::contents(path);
    for (std::size_t at = 0; at < whole.size(); at += whole.size() / 97) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 1);
        fs::remove(path);  // the predecessor may share the file
        test::overwrite(path, bytes);
        std::string notice;
        EXPECT_EQ(load(path, &notice), numbered(1)) << at;
        EXPECT_NE(notice.find("checkpoint.h5.prev"), std::string::npos);
    }
}

TEST(Checkpoint, TruncatedAtAnyLengthFallsBackToThePreviousOne) {
    const Scratch folder;
    const fs::path path = folder / "checkpoint.h5";
    save(path, numbered(1));
    save(path, numbered(2));
    const std::string whole = test::contents(path);
    for (std::size_t size = 0; size < whole.size(); size += whole.size() / 31) {
        test::overwrite(path, whole.substr(0, size));
        EXPECT_EQ(load(path), numbered(1)) << size;
    }
    fs::remove(path);
    EXPECT_EQ(load(path), numbered(1));
}

TEST(Checkpoint, DamagedOneDoesNotReplaceAWholePredecessor) {
    const Scratch folder;
    const fs::path path = folder / "checkpoint.h5";
    save(path, numbered(1));
    save(path, numbered(2));
    test::overwrite(path, "junk");
    { CheckpointWriter unfinished(path, {"abc", "v1", 0}); }  // never committed
    EXPECT_EQ(load(path), numbered(1));
    save(path, numbered(3));
    test::overwrite(path, "junk");
    EXPECT_EQ(load(path), numbered(1));
}

TEST(Checkpoint, RefusesWithOneLineWhenNothingIsWhole) {
    const Scratch folder;
    const fs::path path = folder / "checkpoint.h5";
    EXPECT_THROW(load(path), InputError);
    test::overwrite(path, "junk");
    const std::string message = test::message_of<InputError>([&] { load(path); });
    EXPECT_NE(message.find("no whole checkpoint"), std::string::npos) << message;
    EXPECT_NE(message.find("without --resume"), std::string::npos) << message;
}

TEST(Checkpoint, RefusesAnotherScene) {
    const Scratch folder;
    save(folder / "checkpoint.h5", State{}, "other");
    const std::string message = test::message_of<InputError>([&] { load(folder / "checkpoint.h5"); });
    EXPECT_NE(message.find("another scene"), std::string::npos) << message;
}

TEST(Checkpoint, MissingFieldIsNamed) {
    const Scratch folder;
    save(folder / "checkpoint.h5", State{});
    CheckpointReader reader(folder / "checkpoint.h5", "abc");
    std::vector<double> values;
    const std::string message = test::message_of<InputError>([&] { reader.field("points/mass", values); });
    EXPECT_NE(message.find("/state/points/mass"), std::string::npos) << message;
}

// A child writes checkpoints as fast as it can and is killed without warning, many times over.
TEST(Checkpoint, WriterKilledAtAnyMomentLeavesAWholeOne) {
    const Scratch folder;
    const fs::path path = folder / "checkpoint.h5";
    save(path, numbered(0));
    double furthest = 0;
    for (int round = 0; round < 25; ++round) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (int n = 0;; ++n) save(path, numbered(n));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(3 + 7 * round % 40));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        std::string notice;
        const State state = load(path, &notice);
        EXPECT_EQ(state, numbered(state.x.front()));
        furthest = std::max(furthest, state.x.front());
        EXPECT_EQ(notice, "");  // the final name never holds a half-written file
    }
    EXPECT_GT(furthest, 0);  // the child did write
}

}  // namespace
}  // namespace sandgraph::io
