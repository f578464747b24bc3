#include "io/folder_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <optional>
#include <thread>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::message_of;
using test::overwrite;
using test::Scratch;

TEST(FolderLock, RefusesASecondOwnerAndNamesTheFirst) {
    const Scratch scratch;
    const FolderLock first(scratch / "run");
    const std::string message = message_of<InputError>([&] { FolderLock second(scratch / "run"); });
    EXPECT_NE(message.find("process " + std::to_string(getpid())), std::string::npos) << message;
    EXPECT_NE(message.find("-o"), std::string::npos) << message;
}

TEST(FolderLock, IsGivenBack) {
    const Scratch scratch;
    overwrite(scratch / "other", "stays");
    { FolderLock first(scratch.path()); }
    EXPECT_NO_THROW(FolderLock second(scratch.path()));
    EXPECT_EQ(contents(scratch / "other"), "stays");
}

TEST(FolderLock, TakesAwayOnlyTheEmptyFoldersThatItMade) {
    const Scratch scratch;
    { FolderLock lock(scratch / "a/b/c"); }
    EXPECT_FALSE(fs::exists(scratch / "a"));
    EXPECT_TRUE(fs::exists(scratch.path()));
    {
        FolderLock lock(scratch / "a/b/c");
        overwrite(scratch / "a/b/c/run.h5", "result");
    }
    EXPECT_EQ(contents(scratch / "a/b/c/run.h5"), "result");
    fs::create_directories(scratch / "mine");
    { FolderLock lock(scratch / "mine"); }
    EXPECT_TRUE(fs::exists(scratch / "mine"));
}

// The kernel's lock: what a killed process leaves behind locks nobody out.
TEST(FolderLock, DiesWithItsProcess) {
    const Scratch scratch;
    const pid_t child = fork();
    if (child == 0) {
        FolderLock lock(scratch / "run");
        raise(SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_NO_THROW(FolderLock(scratch / "run"));
}

TEST(AtomicFile, OfManyWritersTheLastWinsWhole) {
    const Scratch scratch;
    const fs::path file = scratch / "same.csv";
    std::vector<std::jthread> writers;
    for (int k = 0; k < 4; ++k)
        writers.emplace_back([&, k] {
            for (int again = 0; again < 20; ++again)
                write_text(file, std::string(100'000, static_cast<char>('a' + k)));
        });
    writers.clear();
    const std::string text = contents(file);
    EXPECT_EQ(text, std::string(100'000, text.at(0)));
    for (const auto& entry : fs::directory_iterator(scratch.path())) EXPECT_EQ(entry.path(), file);
}

TEST(AtomicFile, SweepsWhatADeadWriterHasLeft) {
    const Scratch scratch;
    const pid_t dead = fork();
    if (dead == 0) _exit(0);
    waitpid(dead, nullptr, 0);
    const auto left = [&](pid_t pid) { return scratch / ("x.h5." + std::to_string(pid) + "-999.tmp"); };
    for (const fs::path& file :
         {left(dead), left(getpid()), scratch / "x.h5.copy.tmp", scratch / "y.h5.1-0.tmp"}) {
        overwrite(file, "part");
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
    }
    write_text(scratch / "x.h5", "whole");
    EXPECT_FALSE(fs::exists(left(dead)));
    EXPECT_TRUE(fs::exists(left(getpid())));
    EXPECT_TRUE(fs::exists(scratch / "x.h5.copy.tmp"));
    EXPECT_TRUE(fs::exists(scratch / "y.h5.1-0.tmp"));
    remove_temporaries(scratch.path());  // by the folder's owner
    EXPECT_FALSE(fs::exists(left(getpid())));
    EXPECT_FALSE(fs::exists(scratch / "y.h5.1-0.tmp"));
    EXPECT_TRUE(fs::exists(scratch / "x.h5.copy.tmp"));
    EXPECT_EQ(contents(scratch / "x.h5"), "whole");
}

}  // namespace
}  // namespace sandgraph::io
