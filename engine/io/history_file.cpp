#include "io/history_file.hpp"

#include <fmt/format.h>

#include "base/contracts.hpp"
#include "io/atomic_file.hpp"
#include "io/content.hpp"
#include "io/h5_file.hpp"
#include "io/h5_table.hpp"
#include "io/history_columns.hpp"

namespace sandgraph::io {
namespace {

constexpr std::int64_t schema = 1;
constexpr std::size_t block = 4096;  // rows written at once: one chunk of each column

template <class Row>
void write_table(h5::Group group, std::span<const Row> rows) {
    h5::create_table<Row>(group);
    h5::append_table(group, rows);
}

void write_source(h5::Group& root, const HistorySource& source) {
    mark_content(root, "history", schema);
    h5::set_attribute(root, ".", "kind", source.kind);
    h5::set_attribute(root, ".", "text", source.text);
    h5::set_attribute(root, ".", "version", source.version);
    h5::set_attribute(root, ".", "git", source.git);
}

HistorySource read_source(const h5::Group& root) {
    return {h5::get_text(root, ".", "kind"), h5::get_text(root, ".", "text"),
            h5::get_text(root, ".", "version"), h5::get_text(root, ".", "git")};
}

void check_reference(const h5::Group& group, const char* what, std::int32_t index, std::size_t size) {
    if (index < 0 || static_cast<std::size_t>(index) >= size)
        h5::refuse(group, fmt::format("{} refers to {} {}", group.path(), what, index),
                   fmt::format("the file has {}", size));
}

void check_histories(const h5::Group& group, const HistoryLog& log) {
    for (std::size_t h = 0; h < log.histories.size(); ++h) {
        const HistoryInfo& info = log.histories[h];
        check_reference(group, "packing", info.packing, log.packings.size());
        if (info.twin != HistoryTwin::none) check_reference(group, "history", info.twin_of, h);
    }
}

// Sorts by history and checks that each one's rows came in sequence without a gap.
void sort_rows(const h5::Group& group, std::vector<HistoryRow> rows, HistoryLog& log) {
    std::vector<std::int32_t> length(log.histories.size(), 0);
    for (const HistoryRow& row : rows) {
        check_reference(group, "history", row.history, length.size());
        std::int32_t& next = length[static_cast<std::size_t>(row.history)];
        if (row.sequence != next)
            h5::refuse(group, fmt::format("rows of history {} are out of order", row.history),
                       fmt::format("row {} follows row {}", row.sequence, next - 1));
        if (row.volume_ratio <= 0 || row.dt < 0 || row.dem_steps < 0)
            h5::refuse(group, fmt::format("row {} of history {} is impossible", next, row.history),
                       "J must be above 0, dt and dem_steps not below");
        ++next;
    }
    log.begin.assign(1, 0);
    for (const std::int32_t n : length) log.begin.push_back(log.begin.back() + static_cast<std::size_t>(n));
    log.rows.resize(rows.size());
    for (const HistoryRow& row : rows)
        log.rows[log.begin[static_cast<std::size_t>(row.history)] + static_cast<std::size_t>(row.sequence)] =
            row;
}

}  // namespace

struct HistoryWriter::File {
    explicit File(const std::filesystem::path& path)
        : target(path), h5(h5::File::create(target.temporary())), rows(h5.root().create("history")) {}
    AtomicFile target;
    h5::File h5;
    h5::Group rows;
};

HistoryWriter::HistoryWriter(const std::filesystem::path& path, const HistorySource& source,
                             std::span<const HistoryPacking> packings, std::span<const HistoryInfo> histories)
    : file_(std::make_unique<File>(path)) {
    h5::Group root = file_->h5.root();
    write_source(root, source);
    write_table(root.create("packings"), packings);
    write_table(root.create("histories"), histories);
    h5::create_table<HistoryRow>(file_->rows);
}

HistoryWriter::~HistoryWriter() = default;

void HistoryWriter::append(std::span<const HistoryRow> rows) {
    SG_EXPECT(file_ != nullptr);
    for (const HistoryRow& row : rows) {
        pending_.push_back(row);
        if (pending_.size() == block) write_pending();
    }
}

void HistoryWriter::write_pending() {
    h5::append_table(file_->rows, std::span<const HistoryRow>(pending_));
    pending_.clear();
}

void HistoryWriter::commit() {
    write_pending();
    file_->h5.close();
    file_->target.commit();
}

HistorySource read_history_source(const std::filesystem::path& path) {
    const h5::File file = h5::File::open(path);
    require_content(file.root(), "history", schema);
    return read_source(file.root());
}

HistoryLog read_history(const std::filesystem::path& path) {
    const h5::File file = h5::File::open(path);
    const h5::Group root = file.root();
    require_content(root, "history", schema);
    HistoryLog log;
    log.source = read_source(root);
    log.packings = h5::read_table<HistoryPacking>(root.open("packings"));
    log.histories = h5::read_table<HistoryInfo>(root.open("histories"));
    check_histories(root.open("histories"), log);
    sort_rows(root.open("history"), h5::read_table<HistoryRow>(root.open("history")), log);
    return log;
}

}  // namespace sandgraph::io
