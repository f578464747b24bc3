#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/h5_group.hpp"

namespace sandgraph::io {

// One point handed from the surrogate to its grains.
struct SwitchRow {
    std::int64_t step = 0;
    double d_over_B = 0;
    std::int32_t point = 0;
    std::uint8_t reason = 0;  // index into ScreeningRecord::reasons
    double jump = 0;          // stress jump, share of p
    // Largest change of the ground's stress in a step while the jump fades, and in as many steps after it,
    // shares of p; NaN: no such step, or not recorded.
    double felt = std::numeric_limits<double>::quiet_NaN(), ordinary = felt;
};

// One audit: mean stress error of the points that the surrogate answers for, share of p.
struct AuditPoint {
    double d_over_B = 0;
    double points = 0, population = 0;  // looked at, and stood for
    double mean = 0, ci95 = 0;          // half width of the 95 % interval
};

// What only a screening run has; empty otherwise.
struct ScreeningRecord {
    std::vector<std::string> reasons;
    std::vector<SwitchRow> switches;
    std::vector<AuditPoint> audits;
    bool empty() const { return reasons.empty(); }
};

// The groups /switches and /audit of run.h5, a dataset a column; none for an empty record.
void write_screening(h5::Group& root, const ScreeningRecord& record);
ScreeningRecord read_screening(const h5::Group& root);

}  // namespace sandgraph::io
