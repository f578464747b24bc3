#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/contracts.hpp"
#include "base/tensor.hpp"
#include "stress/surrogate.hpp"

// What packings went through, update by update: the training set of a surrogate (DESIGN section 9). Written
// by runs and by probes in one format. Everything of the grains is compression positive, in the lab frame.
namespace sandgraph::io {

enum class HistoryMode : std::uint8_t { dem, surrogate, replay, audit };
enum class HistoryStatus : std::uint8_t { ok, floating, bad_increment, diverged };  // as dem::RveStatus

// One update of one packing. After a status other than ok or floating the packing is as it was before.
struct HistoryRow {
    std::int32_t history = 0;   // row of HistoryLog::histories
    std::int32_t sequence = 0;  // 0, 1, 2, ... inside its history
    HistoryMode mode = HistoryMode::dem;
    HistoryStatus status = HistoryStatus::ok;
    Mat2 F_inc = Mat2::Identity();  // since the history's previous row, with its spin
    double volume_ratio = 1;        // J since the start
    double dt = 0;                  // time since the history's previous row [s]
    std::int32_t dem_steps = 0;
    float inertial_number = 0;
    float unbalanced = 0;        // mean |net force| on a grain / mean |contact force|
    Mat2 stress = Mat2::Zero();  // Love-Weber, after the update [Pa], not symmetrised
    float p = 0, q = 0;          // mean stress and radius of Mohr's circle [Pa]
    float void_ratio = 0;        // n/(1 - n), 2D
    float coordination = 0;      // Z = 2 Nc/N
    float sliding_fraction = 0;
    std::array<float, 3> fabric{};  // (1/Nc) sum n (x) n: xx, yy, xy
    std::array<float, 4> energy{};  // elastic normal, tangential, rolling; kinetic [J], whole depth
};

// A packing that histories start from, at rest.
enum class HistoryDensity : std::uint8_t { dense, loose, custom };
struct HistoryPacking {
    std::int64_t hash = 0;  // of the packing's bits
    std::int64_t seed = 0;  // of its recipe: split training sets by it, never by row
    HistoryDensity density = HistoryDensity::dense;
    double target_porosity = 0;  // of its recipe
    stress::PackingTraits traits;
    Mat2 stress = Mat2::Zero();  // at the start [Pa]
};

// Where a history's strain came from. `pull`: a material point of a run; the others are probes.
enum class HistoryPath : std::uint8_t {
    pull,
    proportional,
    cyclic,
    dither,
    rotating,
    constant_volume,
    constant_pressure,
    mixed,
    critical_shear  // "flow" in files: long shear to the critical state
};
// A twin repeats the strain path of an earlier history: on another packing of the same kind, turned by
// `rotation`, or with its increments cut in ten or ten of them joined. Twins measure the noise floor.
enum class HistoryTwin : std::uint8_t { none, other_seed, rotated, finer, coarser };

struct HistoryInfo {
    std::int32_t packing = 0;  // row of HistoryLog::packings
    std::int32_t point = -1;   // material point of a run, -1: a probe
    double x = 0, y = 0;       // of that point at the start [m]
    HistoryPath path = HistoryPath::pull;
    HistoryTwin twin = HistoryTwin::none;
    std::int32_t twin_of = -1;  // row of HistoryLog::histories
    double rotation = 0;        // [rad]
};

// Where a log came from.
struct HistorySource {
    std::string kind;  // "run" or "probe"
    std::string text;  // scene or recipe, TOML
    std::string version, git;
    friend bool operator==(const HistorySource&, const HistorySource&) = default;
};

struct HistoryLog {
    HistorySource source;
    std::vector<HistoryPacking> packings;
    std::vector<HistoryInfo> histories;
    std::vector<HistoryRow> rows;    // history by history, in sequence
    std::vector<std::size_t> begin;  // [histories + 1]: rows begin[h] .. begin[h + 1] - 1 are of history h

    std::span<const HistoryRow> of(std::size_t history) const {
        SG_EXPECT(history + 1 < begin.size());
        return std::span(rows).subspan(begin[history], begin[history + 1] - begin[history]);
    }
};

// Names of an enumeration's values in their order, as they stand in files.
std::span<const char* const> names(HistoryMode);
std::span<const char* const> names(HistoryStatus);
std::span<const char* const> names(HistoryDensity);
std::span<const char* const> names(HistoryPath);
std::span<const char* const> names(HistoryTwin);
template <class Enum>
const char* name(Enum value) {
    SG_EXPECT(static_cast<std::size_t>(value) < names(value).size());
    return names(value)[static_cast<std::size_t>(value)];
}

// Counts for people: packings by density, histories and updates by path, twins.
std::string history_overview(const HistoryLog& log);

}  // namespace sandgraph::io
