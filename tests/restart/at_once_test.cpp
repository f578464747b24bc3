#include <array>
#include <functional>

#include "tests/restart/interrupted_run.hpp"

namespace sandgraph::restart {
namespace {

constexpr std::size_t kCount = 3;

// Three programs that write the same file at the same time.
class AtOnce : public InterruptedRun {
  protected:
    void write(const std::string& name, const std::string& text) const { std::ofstream(out(name)) << text; }
    pid_t program(std::vector<std::string> words) const {
        words.insert(words.begin(), sandgraph::test::program());
        return support::start_program(std::move(words), "/dev/null");
    }
    // Their exit codes, in order of size.
    std::array<int, kCount> all_of(const std::function<pid_t(std::size_t)>& start) const {
        std::array<pid_t, kCount> started{};
        for (std::size_t k = 0; k < kCount; ++k) started[k] = start(k);
        std::array<int, kCount> codes{};
        for (std::size_t k = 0; k < kCount; ++k) codes[k] = finish(started[k]);
        std::ranges::sort(codes);
        return codes;
    }
    std::vector<std::string> named(const std::string& stem) const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_))
            if (entry.path().filename().string().starts_with(stem + "."))
                names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }
};

std::string recipe(std::size_t seed) { return "[grains]\ncount = 50\nseed = " + std::to_string(seed) + "\n"; }

// The last to end wins, whole: recipe and grains are of one writer, and nobody leaves a temporary file.
TEST_F(AtOnce, PackingsOfOneNameAreWhole) {
    const auto prepare = [&](std::size_t k, const std::string& name) {
        write("r" + std::to_string(k) + ".toml", recipe(k));
        return program({"rve", "prepare", out("r" + std::to_string(k) + ".toml"), "-o", out(name)});
    };
    EXPECT_EQ(all_of([&](std::size_t k) { return prepare(k, "same.h5"); }), (std::array{0, 0, 0}));
    EXPECT_EQ(named("same"), std::vector<std::string>{"same.h5"});
    const io::PackingRecord same = io::read_packing(out("same.h5"));
    int writers = 0;
    for (std::size_t k = 0; k < kCount; ++k) {
        ASSERT_EQ(finish(prepare(k, "alone.h5")), 0);
        const io::PackingRecord alone = io::read_packing(out("alone.h5"));
        if (same.recipe != alone.recipe) continue;
        ++writers;
        EXPECT_EQ(same.packing.x, alone.packing.x);
        EXPECT_EQ(same.packing.contacts.size(), alone.packing.contacts.size());
    }
    EXPECT_EQ(writers, 1);
}

// Model, card and errors belong together: one trains, the others are told so.
TEST_F(AtOnce, OneTrainsAModel) {
    if (!fs::exists(fs::path(sandgraph::test::program()).parent_path() / "sandgraph-train"))
        GTEST_SKIP() << "no libtorch";
    write("t.toml",
          "[data]\nlogs = \"" + sandgraph::test::source_file("/configs/models/table1.guard.h5") +
              "\"\nvalidation_seeds = 0\n[model]\nmembers = 1\n[training]\nepochs = 30\npatience = 30\n");
    const auto train = [&](std::size_t) { return program({"train", out("t.toml"), "-o", out("m.h5")}); };
    EXPECT_EQ(all_of(train), (std::array{0, 2, 2}));
    EXPECT_EQ(named("m"), (std::vector<std::string>{"m.card.json", "m.errors.csv", "m.h5"}));
}

}  // namespace
}  // namespace sandgraph::restart
