#pragma once
#include <filesystem>
#include <fstream>
#include <functional>

#include "io/history.hpp"

namespace sandgraph::io {

inline constexpr const char* journal_name = "history.part";  // in the run folder

// The rows of a history log while a run goes on: a plain file that only grows, so that whatever kills the run
// damages no more than its last rows. A resumed run cuts it back to its checkpoint.
class HistoryJournal {
  public:
    // Keeps the first `rows` rows of the file (0: begins anew). InputError when it has fewer, or is none.
    HistoryJournal(std::filesystem::path path, std::size_t rows);

    void append(std::span<const HistoryRow> rows);
    void sync();  // brings what was appended to the disk
    std::size_t rows() const { return rows_; }
    // The rows in order, some thousands at a time.
    void read(const std::function<void(std::span<const HistoryRow>)>& block) const;

    static std::size_t row_bytes();

  private:
    void cut_back() const;
    std::filesystem::path path_;
    std::size_t rows_;
    std::ofstream out_;
};

}  // namespace sandgraph::io
