#pragma once
#include <string>
#include <vector>

#include "base/contracts.hpp"
#include "io/history.hpp"

namespace sandgraph::training {

// Somebody's run, a probe, or the shipped probes that guard against forgetting: these are never trained on.
enum class Origin { run, probe, guard };

// What one packing went through and what it answered.
struct History {
    io::HistoryInfo info;
    Origin origin = Origin::probe;
    std::int32_t packing = 0;    // index in HistorySet::packings
    std::int64_t twin_of = -1;   // index in HistorySet::histories
    std::vector<Mat2> F_inc;     // each since the row before, with its spin
    std::vector<Stress> stress;  // after each increment, tension positive, lab frame [Pa]
};

struct HistorySet {
    std::vector<io::HistoryPacking> packings;
    std::vector<History> histories;
    std::vector<std::string> sources;  // "FILE hash" of every log

    const io::HistoryPacking& start_of(const History& history) const {
        SG_EXPECT(history.packing >= 0 && static_cast<std::size_t>(history.packing) < packings.size());
        return packings[history.packing];
    }
};

// Of a file's contents.
std::string file_hash(const std::string& file);

// The DEM histories of the logs and of the guard ("": none), one set. A history ends where its packing could
// not follow. InputError on what io::read_history refuses, and when nothing is left.
HistorySet read_histories(const std::vector<std::string>& files, const std::string& guard = "");

}  // namespace sandgraph::training
