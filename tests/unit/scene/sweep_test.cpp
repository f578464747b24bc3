#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "scene/sweep_rows.hpp"
#include "support/paths.hpp"

namespace sandgraph::scene {
namespace {

namespace fs = std::filesystem;

class SweepTables : public testing::Test {
  protected:
    SweepTables() {
        fs::create_directories(folder_);
        write("s.toml", "[domain]\nwidth = \"4 m\"\n");
    }
    ~SweepTables() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    SweepTable read(const std::string& text) const {
        write("t.toml", "scene = \"s.toml\"\n" + text);
        return read_sweep_table((folder_ / "t.toml").string());
    }
    std::vector<std::string> names(const std::string& text) const {
        std::vector<std::string> out;
        for (const SweepRow& row : read(text).rows) out.push_back(row.name);
        return out;
    }
    // "t.toml:3: ..."
    std::string refused(const std::string& text) const {
        try {
            read(text);
        } catch (const InputError& error) {
            return std::string(error.what()).substr(folder_.string().size() + 1);
        }
        return "accepted";
    }
    void expect_refused(const std::string& text, const std::string& where, const std::string& what) const {
        const std::string said = refused(text);
        EXPECT_TRUE(said.starts_with(where + ": ")) << said;
        EXPECT_NE(said.find(what), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }

    fs::path folder_ =
        fs::path(testing::TempDir()) /
        (std::string("sweep_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

constexpr const char* kEmbedment = "[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [2, 3]\n";
constexpr const char* kDensity = "[[axis]]\nkey = \"grains.density\"\nvalues = [\"dense\", \"loose\"]\n";

TEST_F(SweepTables, ProductHasEveryPairAndTheLastAxisRunsFastest) {
    EXPECT_EQ(
        names(std::string(kEmbedment) + kDensity),
        (std::vector<std::string>{"embedment_ratio=2_density=dense", "embedment_ratio=2_density=loose",
                                  "embedment_ratio=3_density=dense", "embedment_ratio=3_density=loose"}));
}

TEST_F(SweepTables, ZipTakesAxesInStep) {
    EXPECT_EQ(
        names(std::string("combine = \"zip\"\n") + kEmbedment + kDensity),
        (std::vector<std::string>{"embedment_ratio=2_density=dense", "embedment_ratio=3_density=loose"}));
}

TEST_F(SweepTables, CompanionsChangeWithTheirAxisAndAreNotInTheName) {
    const SweepTable table =
        read(std::string(kEmbedment) + "with = { \"domain.depth\" = [\"7 m\", \"8 m\"] }\n");
    EXPECT_EQ(table.keys, (std::vector<std::string>{"anchor.embedment_ratio", "domain.depth"}));
    EXPECT_EQ(table.axes, std::vector<std::size_t>{0});
    EXPECT_EQ(table.rows[1].name, "embedment_ratio=3");
    EXPECT_EQ(table.overrides(table.rows[1]),
              (std::vector<std::string>{"anchor.embedment_ratio=3", "domain.depth='8 m'"}));
}

TEST_F(SweepTables, KeysThatEndAlikeAreNamedInFull) {
    const SweepTable table = read(
        "[[axis]]\nkey = \"anchor.width\"\nvalues = [\"1 m\"]\n"
        "[[axis]]\nkey = \"domain.width\"\nvalues = [\"4 m\"]\n");
    EXPECT_EQ(table.rows[0].name, "anchor.width=1m_domain.width=4m");
}

TEST_F(SweepTables, LinesOfACsvAreRows) {
    write("r.csv", "name,anchor.embedment_ratio,domain.depth\n# deep ones\nA,2,7 m\nB,3,8 m\n");
    const SweepTable table = read("rows = \"r.csv\"\n[set]\ngrains.count = 100\n");
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[1].name, "B");
    EXPECT_EQ(table.overrides(table.rows[1]),
              (std::vector<std::string>{"grains.count=100", "anchor.embedment_ratio=3", "domain.depth=8 m"}));
}

TEST_F(SweepTables, SamplesAloneAreASweepOfOneRow) {
    EXPECT_EQ(names("samples = 20\n"), std::vector<std::string>{"all"});
}

TEST_F(SweepTables, UnknownKeysAreRefusedAtTheirLineWithTheScenesAdvice) {
    expect_refused("[[axis]]\nkey = \"anchor.embedment_ration\"\nvalues = [2]\n", "t.toml:2",
                   "did you mean \"embedment_ratio\"");
    expect_refused(std::string(kEmbedment) + "[set]\ngrains.dense = 1\n", "t.toml:6",
                   "unknown key grains.dense");
    expect_refused("axes = 3\n", "t.toml:2", "did you mean \"axis\"");
    expect_refused("[[axis]]\nkey = \"anchor\"\nvalues = [2]\n", "t.toml:2", "anchor");
    expect_refused("[[axis]]\nkey = \"no key\"\nvalues = [2]\n", "t.toml:2", "not a key");
}

TEST_F(SweepTables, ValuesAreCheckedAsInAScene) {
    expect_refused("[[axis]]\nkey = \"domain.depth\"\nvalues = [7]\n", "t.toml:2", "no unit");
    expect_refused("[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [2, -1]\n", "t.toml:2",
                   "out of range");
    expect_refused("[[axis]]\nkey = \"grains.density\"\nvalues = [\"thick\"]\n", "t.toml:2", "dense");
}

TEST_F(SweepTables, WhatCannotBeCombinedIsRefused) {
    expect_refused("[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = []\n", "t.toml:4", "without values");
    expect_refused("[[axis]]\nkey = \"anchor.embedment_ratio\"\n", "t.toml:2", "without values");
    expect_refused("combine = \"zip\"\n[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [1]\n" +
                       std::string(kDensity),
                   "t.toml:6", "in step");
    expect_refused(std::string(kEmbedment) + "with = { \"domain.depth\" = [\"7 m\"] }\n", "t.toml:5",
                   "they go together");
    expect_refused(std::string(kEmbedment) + kEmbedment, "t.toml:5", "anchor.embedment_ratio twice");
    expect_refused("", "t.toml", "a sweep of nothing");
}

TEST_F(SweepTables, TwoRowsOfOneFolderAreRefused) {
    expect_refused("[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [2, 3, 2]\n", "t.toml:2",
                   "both would have the folder embedment_ratio=2");
    write("r.csv", "name,anchor.embedment_ratio\nA,2\nA,3\n");
    expect_refused("rows = \"r.csv\"\n", "r.csv:3", "rows 1 and 2");
}

TEST_F(SweepTables, ColumnsOfACsvAreKeys) {
    write("r.csv", "anchor.embedment_ratio,depth\n2,7 m\n");
    expect_refused("rows = \"r.csv\"\n", "r.csv:1", "unknown key depth");
    write("r.csv", "anchor.embedment_ratio,domain.depth\n2\n");
    expect_refused("rows = \"r.csv\"\n", "r.csv:2", "the head has 2");
    write("r.csv", "name,anchor.embedment_ratio\n../up,2\n");
    expect_refused("rows = \"r.csv\"\n", "r.csv:2", "it names a folder");
    write("r.csv", "anchor.embedment_ratio\n");
    expect_refused("rows = \"r.csv\"\n", "r.csv", "no rows");
    expect_refused("rows = \"r.csv\"\n" + std::string(kEmbedment), "t.toml:3", "no effect");
}

TEST_F(SweepTables, FolderOfARunIsTheSweeps) {
    expect_refused("samples = 2\n[set]\noutput.folder = \"x\"\n", "t.toml:4", "a folder of its own");
}

}  // namespace
}  // namespace sandgraph::scene
