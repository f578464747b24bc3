#include "io/history_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <functional>
#include <limits>

#include "base/error.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "io/info.hpp"
#include "support/paths.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

using test::Scratch;

HistoryRow row(std::int32_t history, std::int32_t sequence) {
    HistoryRow r;
    r.history = history, r.sequence = sequence;
    r.F_inc << 1 + 1e-5 * sequence, 2e-5, -3e-5, 1 - 1e-5 / 3;
    r.volume_ratio = r.F_inc.determinant(), r.dt = 1e-4, r.dem_steps = 7 + history;
    r.stress << 10e3, 100.0 / 3, 99, 11e3 + sequence;
    r.p = 10.5e3f, r.q = 0.5e3f, r.void_ratio = 0.2f, r.coordination = 3.5f;
    r.fabric = {0.51f, 0.49f, 0.01f}, r.energy = {1e-3f, 2e-3f, 3e-4f, 1e-9f};
    r.status = sequence == 1 ? HistoryStatus::floating : HistoryStatus::ok;
    return r;
}

HistoryLog small_log() {
    HistoryLog log;
    log.source = {"probe", "seed = 1\n", "0.1", "abc"};
    HistoryPacking packing;
    packing.hash = -17, packing.seed = 3, packing.density = HistoryDensity::loose;
    packing.target_porosity = 0.2;
    packing.traits = {10e3, 0.2, 20e6, 14e6, 3.4, 0.01, -0.02, 0.42};
    packing.stress << 10e3, 1, 2, 10e3;
    log.packings = {packing};
    HistoryInfo first, twin;
    first.path = HistoryPath::cyclic;
    twin = first, twin.twin = HistoryTwin::rotated, twin.twin_of = 0, twin.rotation = 0.7;
    log.histories = {first, twin};
    for (int k = 0; k < 3; ++k) log.rows.push_back(row(0, k)), log.rows.push_back(row(1, k));
    return log;
}

void write(const std::filesystem::path& path, const HistoryLog& log) {
    HistoryWriter writer(path, log.source, log.packings, log.histories);
    for (const HistoryRow& r : log.rows) writer.append(std::span(&r, 1));
    writer.commit();
}

void expect_same(const HistoryRow& a, const HistoryRow& b) {
    EXPECT_EQ(a.F_inc, b.F_inc);
    EXPECT_EQ(a.stress, b.stress);
    EXPECT_EQ(a.volume_ratio, b.volume_ratio);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.dem_steps, b.dem_steps);
    EXPECT_EQ(a.fabric, b.fabric);
    EXPECT_EQ(a.energy, b.energy);
    EXPECT_EQ(a.coordination, b.coordination);
}

TEST(HistoryFile, ReadsBackEveryBitHistoryByHistory) {
    const Scratch folder;
    const HistoryLog log = small_log();
    write(folder / "log.h5", log);
    const HistoryLog read = read_history(folder / "log.h5");
    EXPECT_EQ(read.source, log.source);
    ASSERT_EQ(read.histories.size(), 2u);
    EXPECT_EQ(read.histories[1].twin, HistoryTwin::rotated);
    EXPECT_EQ(read.histories[1].rotation, 0.7);
    EXPECT_EQ(read.packings.at(0).hash, -17);
    EXPECT_EQ(read.packings[0].traits.fabric_xy, -0.02);
    EXPECT_EQ(read.packings[0].stress, log.packings[0].stress);
    for (int h = 0; h < 2; ++h) {
        ASSERT_EQ(read.of(h).size(), 3u);
        for (int k = 0; k < 3; ++k) expect_same(read.of(h)[k], row(h, k));
    }
}

TEST(HistoryFile, GrowsPastItsBlocks) {
    const Scratch folder;
    HistoryLog log = small_log();
    log.rows.clear();
    for (int k = 0; k < 9000; ++k) log.rows.push_back(row(0, k));
    write(folder / "log.h5", log);
    const HistoryLog read = read_history(folder / "log.h5");
    ASSERT_EQ(read.of(0).size(), 9000u);
    EXPECT_EQ(read.of(1).size(), 0u);
    for (const int k : {0, 4095, 4096, 8191, 8999}) expect_same(read.of(0)[k], row(0, k));
}

TEST(HistoryFile, AppearsOnlyWhenCommitted) {
    const Scratch folder;
    {
        const HistoryLog log = small_log();
        HistoryWriter writer(folder / "log.h5", log.source, log.packings, log.histories);
        writer.append(log.rows);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(HistoryFile, InfoTellsWhatIsInIt) {
    const Scratch folder;
    write(folder / "log.h5", small_log());
    const std::string text = info(folder / "log.h5");
    for (const char* part : {"content = \"history\"", "kind = \"probe\"", "F_inc", "(6 x 4)", "[Pa]", "(2)",
                             "(dense loose custom)", "1 packings (loose 1) of 1 seeds",
                             "6 updates in 2 histories (none 1, rotated 1)"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

std::string refusal(const std::function<void(HistoryLog&)>& damage) {
    const Scratch folder;
    HistoryLog log = small_log();
    damage(log);
    write(folder / "log.h5", log);
    return test::message_of<InputError>([&] { read_history(folder / "log.h5"); });
}

TEST(HistoryFile, RefusesRowsThatCannotBe) {
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    };
    expect(refusal([&](HistoryLog& l) { l.rows[2].stress(0, 1) = nan; }), "/history/stress holds nan");
    expect(refusal([&](HistoryLog& l) { l.rows[4].q = std::numeric_limits<float>::infinity(); }),
           "q holds inf");
    expect(refusal([](HistoryLog& l) { std::swap(l.rows[0], l.rows[2]); }), "history 0 are out of order");
    expect(refusal([](HistoryLog& l) { l.rows.erase(l.rows.begin() + 3); }), "history 1 are out of order");
    expect(refusal([](HistoryLog& l) { l.rows[0].volume_ratio = 0; }), "row 0 of history 0 is impossible");
    expect(refusal([](HistoryLog& l) { l.rows[5].history = 2; }), "history 2");
    expect(refusal([](HistoryLog& l) { l.histories[1].packing = 1; }), "packing 1");
    expect(refusal([](HistoryLog& l) { l.histories[1].twin_of = 1; }), "history 1");
    expect(refusal([](HistoryLog& l) { l.histories[0].path = HistoryPath(99); }), "path holds 99");
}

std::string refusal_of_file(const std::function<void(h5::Group&)>& damage) {
    const Scratch folder;
    write(folder / "log.h5", small_log());
    {
        h5::File file = h5::File::open(folder / "log.h5", h5::Access::edit);
        h5::Group root = file.root();
        damage(root);
        file.close();
    }
    return test::message_of<InputError>([&] { read_history(folder / "log.h5"); });
}

TEST(HistoryFile, RefusesForeignSchemasAndMissingColumns) {
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect(refusal_of_file([](h5::Group& g) { h5::set_attribute(g, ".", "schema", std::int64_t{2}); }),
           "history schema 2");
    expect(refusal_of_file([](h5::Group& g) { h5::set_attribute(g, ".", "content", std::string("run")); }),
           "this is a run file");
    expect(refusal_of_file([](h5::Group& g) { g.remove("history/fabric"); }), "/history/fabric is missing");
    expect(refusal_of_file([](h5::Group& g) { g.remove("packings"); }), "/packings is missing");
    expect(refusal_of_file([](h5::Group& g) {
               h5::Group rows = g.open("history");
               h5::truncate(rows, "stress", 5);
           }),
           "/history/stress differs in shape");
    expect(refusal_of_file([](h5::Group& g) {  // a scalar: found by fuzzing
               const double one = 1;
               h5::Group packings = g.open("packings");
               packings.remove("target_porosity");
               h5::write(packings, "target_porosity", std::span(&one, 1), {}, "", h5::Storage::contiguous);
           }),
           "/packings/target_porosity differs in shape");
    expect(refusal_of_file([](h5::Group& g) {
               h5::Group histories = g.open("histories");
               h5::set_attribute(histories, "path", "values", std::string("other words"));
           }),
           "the values of /histories/path differ");
}

TEST(HistoryFile, RefusesATruncatedFile) {
    const Scratch folder;
    write(folder / "log.h5", small_log());
    const std::string bytes = test::contents(folder / "log.h5");
    test::overwrite(folder / "log.h5", bytes.substr(0, bytes.size() / 2));
    EXPECT_THROW(read_history(folder / "log.h5"), InputError);
    EXPECT_THROW(read_history(folder / "none.h5"), InputError);
}

// Made by the recipe beside it as it stands there, so that whoever follows the recipe gets the same log.
TEST(ShippedGuard, HoldsTheRecipeThatMakesIt) {
    const std::string models = sandgraph::test::source_file("/configs/models/");
    EXPECT_EQ(read_history_source(models + "table1.guard.h5").text,
              test::contents(models + "probe_guard.toml"));
}

}  // namespace
}  // namespace sandgraph::io
