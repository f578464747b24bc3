#include "io/history.hpp"

#include <fmt/format.h>

#include <set>

namespace sandgraph::io {
namespace {

constexpr std::array modes{"dem", "surrogate", "replay", "audit"};
constexpr std::array statuses{"ok", "floating", "bad_increment", "diverged"};
constexpr std::array densities{"dense", "loose", "custom"};
constexpr std::array paths{
    "pull",  "proportional", "cyclic", "dither", "rotating", "constant_volume", "constant_pressure",
    "mixed", "flow"};
constexpr std::array twins{"none", "other_seed", "rotated", "finer", "coarser"};

// "name count, name count" of the values that occur.
template <class Row, class Enum>
std::string counts(const std::vector<Row>& rows, Enum Row::*member) {
    std::vector<std::size_t> count(names(Enum{}).size());
    for (const Row& row : rows) ++count[static_cast<std::size_t>(row.*member)];
    std::string text;
    for (std::size_t k = 0; k < count.size(); ++k)
        if (count[k] > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names(Enum{})[k], count[k]);
    return text;
}

std::string path_line(HistoryPath path, const HistoryLog& log) {
    std::size_t count = 0, updates = 0;
    for (std::size_t h = 0; h < log.histories.size(); ++h)
        if (log.histories[h].path == path) ++count, updates += log.of(h).size();
    if (count == 0) return "";
    return fmt::format("    {:<18} {:>6} histories {:>9} updates\n", name(path), count, updates);
}

}  // namespace

std::span<const char* const> names(HistoryMode) { return modes; }
std::span<const char* const> names(HistoryStatus) { return statuses; }
std::span<const char* const> names(HistoryDensity) { return densities; }
std::span<const char* const> names(HistoryPath) { return paths; }
std::span<const char* const> names(HistoryTwin) { return twins; }

std::string history_overview(const HistoryLog& log) {
    std::set<std::int64_t> seeds;
    for (const HistoryPacking& p : log.packings) seeds.insert(p.seed);
    std::string text =
        fmt::format("  {} packings ({}) of {} seeds\n  {} updates in {} histories ({})\n",
                    log.packings.size(), counts(log.packings, &HistoryPacking::density), seeds.size(),
                    log.rows.size(), log.histories.size(), counts(log.histories, &HistoryInfo::twin));
    for (std::size_t path = 0; path < names(HistoryPath{}).size(); ++path)
        text += path_line(static_cast<HistoryPath>(path), log);
    return text;
}

}  // namespace sandgraph::io
