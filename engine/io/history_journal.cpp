#include "io/history_journal.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/byte_stream.hpp"
#include "base/contracts.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/h5_table.hpp"
#include "io/history_columns.hpp"

namespace sandgraph::io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t block_rows = 4096;

// One row as bytes, column behind column.
void put(ByteWriter& out, const HistoryRow& row) {
    columns(std::type_identity<HistoryRow>{}, [&](const char*, const char*, auto... path) {
        using Cells = h5::Cells<std::remove_cvref_t<decltype(h5::member_of(row, path...))>>;
        typename Cells::Stored cells[Cells::count];
        Cells::put(h5::member_of(row, path...), cells);
        out.put(std::span<const typename Cells::Stored>(cells));
    });
}

void take(ByteReader& in, HistoryRow& row) {
    columns(std::type_identity<HistoryRow>{}, [&](const char*, const char*, auto... path) {
        using Cells = h5::Cells<std::remove_cvref_t<decltype(h5::member_of(row, path...))>>;
        typename Cells::Stored cells[Cells::count];
        in.take(std::span<typename Cells::Stored>(cells));
        Cells::take(cells, h5::member_of(row, path...));
    });
}

}  // namespace

std::size_t HistoryJournal::row_bytes() {
    static const std::size_t size = [] {
        std::vector<std::uint8_t> bytes;
        ByteWriter out(bytes);
        put(out, {});
        return bytes.size();
    }();
    return size;
}

HistoryJournal::HistoryJournal(fs::path path, std::size_t rows) : path_(std::move(path)), rows_(rows) {
    if (rows_ > 0) cut_back();
    out_.open(path_, std::ios::binary | (rows_ > 0 ? std::ios::app : std::ios::trunc));
    if (!out_) throw std::runtime_error(path_.string() + ": cannot be written");
}

void HistoryJournal::cut_back() const {
    const std::uintmax_t needed = rows_ * row_bytes();
    const std::uintmax_t found = fs::exists(path_) ? fs::file_size(path_) : 0;
    if (found < needed)
        throw InputError({path_.string()}, "the history log ends before the checkpoint",
                         fmt::format("{} bytes, {} needed", found, needed),
                         "start the run anew, without --resume");
    fs::resize_file(path_, needed);
}

void HistoryJournal::append(std::span<const HistoryRow> rows) {
    SG_EXPECT(out_.is_open());
    std::vector<std::uint8_t> bytes;
    bytes.reserve(rows.size() * row_bytes());
    ByteWriter out(bytes);
    for (const HistoryRow& row : rows) put(out, row);
    out_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out_.flush()) throw std::runtime_error(path_.string() + ": cannot be written (disk full?)");
    rows_ += rows.size();
}

void HistoryJournal::sync() { sync_to_disk(path_); }

void HistoryJournal::read(const std::function<void(std::span<const HistoryRow>)>& block) const {
    std::ifstream file(path_, std::ios::binary);
    for (std::size_t begin = 0; begin < rows_; begin += block_rows) {
        std::vector<HistoryRow> rows(std::min(block_rows, rows_ - begin));
        std::vector<std::uint8_t> bytes(rows.size() * row_bytes());
        if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
            throw std::runtime_error(path_.string() + ": cannot be read");
        ByteReader in(bytes);
        for (HistoryRow& row : rows) take(in, row);
        block(rows);
    }
}

}  // namespace sandgraph::io
