#include "io/history_journal.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

using test::Scratch;

std::vector<HistoryRow> some_rows(int count, int from = 0) {
    std::vector<HistoryRow> rows(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        HistoryRow& r = rows[static_cast<std::size_t>(k)];
        r.history = 3, r.sequence = from + k, r.status = HistoryStatus::floating;
        r.F_inc << 1, 1e-5 * k, 0, 1.0 / 3;
        r.stress << 1, 2, 3, 4.0 * k;
        r.energy = {1, 2, 3, float(k)};
    }
    return rows;
}

std::vector<HistoryRow> read(const HistoryJournal& journal) {
    std::vector<HistoryRow> out;
    journal.read([&](std::span<const HistoryRow> rows) { out.insert(out.end(), rows.begin(), rows.end()); });
    return out;
}

TEST(HistoryJournal, GivesBackItsRows) {
    const Scratch folder;
    HistoryJournal journal(folder / "part", 0);
    journal.append(some_rows(5000));
    journal.append(some_rows(3, 5000));
    EXPECT_EQ(journal.rows(), 5003u);
    EXPECT_EQ(std::filesystem::file_size(folder / "part"), 5003 * HistoryJournal::row_bytes());
    const auto rows = read(journal);
    ASSERT_EQ(rows.size(), 5003u);
    EXPECT_EQ(rows[4999].stress(1, 1), 4.0 * 4999);
    EXPECT_EQ(rows[5002].sequence, 5002);
    EXPECT_EQ(rows[77].F_inc, some_rows(78)[77].F_inc);
    EXPECT_EQ(rows[77].status, HistoryStatus::floating);
    EXPECT_EQ(rows[77].energy, some_rows(78)[77].energy);
}

// A run killed after its checkpoint, in the middle of a row.
TEST(HistoryJournal, GoesOnFromTheCheckpointWhateverCameAfterIt) {
    const Scratch folder;
    { HistoryJournal(folder / "part", 0).append(some_rows(10)); }
    std::filesystem::resize_file(folder / "part", 9 * HistoryJournal::row_bytes() + 5);
    HistoryJournal journal(folder / "part", 7);
    journal.append(some_rows(2, 7));
    const auto rows = read(journal);
    ASSERT_EQ(rows.size(), 9u);
    for (int k = 0; k < 9; ++k) EXPECT_EQ(rows[static_cast<std::size_t>(k)].sequence, k);
}

TEST(HistoryJournal, RefusesAFileShorterThanItsCheckpoint) {
    const Scratch folder;
    { HistoryJournal(folder / "part", 0).append(some_rows(3)); }
    const std::string message = test::message_of<InputError>([&] { HistoryJournal(folder / "part", 4); });
    EXPECT_NE(message.find("ends before the checkpoint"), std::string::npos) << message;
    EXPECT_THROW(HistoryJournal(folder / "none", 1), InputError);
}

}  // namespace
}  // namespace sandgraph::io
