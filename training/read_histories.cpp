#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "io/history_file.hpp"
#include "training/history.hpp"

namespace sandgraph::training {
namespace {

History history_of(const io::HistoryLog& log, std::size_t h) {
    History history;
    history.info = log.histories[h];
    for (const io::HistoryRow& row : log.of(h)) {
        if (row.mode == io::HistoryMode::surrogate || row.status > io::HistoryStatus::floating) break;
        history.F_inc.push_back(row.F_inc);
        history.stress.push_back(tension_positive(row.stress));
    }
    return history;
}

void add(HistorySet& set, const io::HistoryLog& log, Origin origin) {
    const auto packings = static_cast<std::int32_t>(set.packings.size());
    const auto histories = static_cast<std::int64_t>(set.histories.size());
    set.packings.insert(set.packings.end(), log.packings.begin(), log.packings.end());
    for (std::size_t h = 0; h < log.histories.size(); ++h) {
        History history = history_of(log, h);
        history.origin = origin;
        history.packing = packings + history.info.packing;
        if (history.info.twin_of >= 0) history.twin_of = histories + history.info.twin_of;
        set.histories.push_back(std::move(history));  // empty ones too: twins count rows
    }
}

}  // namespace

std::string file_hash(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    return hex(hash64(bytes));
}

HistorySet read_histories(const std::vector<std::string>& files, const std::string& guard) {
    HistorySet set;
    std::size_t rows = 0;
    for (const std::string& file : files) {
        const io::HistoryLog log = io::read_history(file);
        add(set, log, log.source.kind == "run" ? Origin::run : Origin::probe);
        set.sources.push_back(fmt::format("{} {}", file, file_hash(file)));
    }
    for (const History& h : set.histories) rows += h.F_inc.size();
    if (rows == 0)
        throw InputError({files.empty() ? "training" : files.front()}, "no DEM update to train on",
                         "the logs hold no history of a packing", "give a log of a full run or of a probe");
    if (!guard.empty()) {
        add(set, io::read_history(guard), Origin::guard);
        set.sources.push_back(fmt::format("{} {}", guard, file_hash(guard)));
    }
    return set;
}

}  // namespace sandgraph::training
