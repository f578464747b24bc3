#pragma once
#include <filesystem>
#include <memory>

#include "io/history.hpp"

namespace sandgraph::io {

// Writes a history log, an HDF5 file (content "history", schema 1) with the groups
//   /history    one row an update: HistoryRow
//   /histories  one row a history: HistoryInfo
//   /packings   one row an initial packing: HistoryPacking
// a growing, compressed dataset a column, each with its unit. The file appears whole, with commit().
class HistoryWriter {
  public:
    HistoryWriter(const std::filesystem::path& path, const HistorySource& source,
                  std::span<const HistoryPacking> packings, std::span<const HistoryInfo> histories);
    ~HistoryWriter();
    // Rows of a history come in sequence; those of different histories may alternate.
    void append(std::span<const HistoryRow> rows);
    void commit();

  private:
    void write_pending();
    struct File;
    std::unique_ptr<File> file_;
    std::vector<HistoryRow> pending_;  // fewer than a block
};

// InputError, one line, when the file is missing, damaged, of another kind or schema, lacks a column, holds a
// number that is not finite, refers to what it does not have, or misses a row inside a history.
HistoryLog read_history(const std::filesystem::path& path);

// What a log was made from, without its rows. InputError as above.
HistorySource read_history_source(const std::filesystem::path& path);

}  // namespace sandgraph::io
