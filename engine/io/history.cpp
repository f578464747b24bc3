#include "io/history.hpp"

namespace sandgraph::io {
namespace {

constexpr std::array modes{"dem", "surrogate", "replay", "audit"};
constexpr std::array statuses{"ok", "floating", "bad_increment", "diverged"};
constexpr std::array densities{"dense", "loose", "custom"};
constexpr std::array paths{
    "pull",  "proportional", "cyclic", "dither", "rotating", "constant_volume", "constant_pressure",
    "mixed", "flow"};
constexpr std::array twins{"none", "other_seed", "rotated", "finer", "coarser"};

}  // namespace

std::span<const char* const> names(HistoryMode) { return modes; }
std::span<const char* const> names(HistoryStatus) { return statuses; }
std::span<const char* const> names(HistoryDensity) { return densities; }
std::span<const char* const> names(HistoryPath) { return paths; }
std::span<const char* const> names(HistoryTwin) { return twins; }

}  // namespace sandgraph::io
