#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/unit/app/bad_input.hpp"

namespace sandgraph::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTest =
    "kind = \"path\"\nrelax_steps = 0\n[[segment]]\nvelocity_gradient = [[0, 0], [0, 0]]\nsteps = 1\n";

Shell::Outcome write_to(const Shell& shell, const std::string& name) {
    shell.write("t.toml", kTest);
    shell.write("p.csv", lattice());
    return shell.run("rve test t.toml --packing p.csv -o " + name);
}

TEST(OutputFile, PipesAndDevicesAreRefusedAndStay) {
    const Shell shell("pipe");
    ASSERT_EQ(::mkfifo(shell.path("pipe").c_str(), 0600), 0);
    fs::create_symlink("/dev/null", shell.path("device"));
    for (const char* name : {"pipe", "device"})
        expect_bad_input(write_to(shell, name), name, "no ordinary file");
    EXPECT_TRUE(fs::is_fifo(shell.path("pipe")));
    EXPECT_TRUE(fs::is_character_file(shell.path("device")));
}

TEST(OutputFile, LinkStaysALink) {
    const Shell shell("link");
    fs::create_directory(shell.path("data"));
    shell.write("data/old.csv", "old");
    fs::create_symlink("data/old.csv", shell.path("again"));
    fs::create_symlink("again", shell.path("old"));
    fs::create_symlink("data/new.csv", shell.path("new"));  // to nothing yet
    for (const std::string name : {"old", "new"}) {
        const auto told = write_to(shell, name);
        ASSERT_EQ(told.exit_code, 0) << told.err;
        EXPECT_TRUE(fs::is_symlink(shell.path(name)));
        EXPECT_EQ(shell.read("data/" + name + ".csv").rfind("# {", 0), 0u);
    }
    EXPECT_TRUE(fs::is_symlink(shell.path("again")));
}

TEST(OutputFile, LinkIntoNoFolderIsRefused) {
    const Shell shell("lost_link");
    fs::create_symlink("nowhere/out.csv", shell.path("out"));
    expect_bad_input(write_to(shell, "out"), "out", "there is no folder");
}

}  // namespace
}  // namespace sandgraph::app
