#pragma once
#include <string>
#include <vector>

#include "io/h5_group.hpp"
#include "stress/screening_log.hpp"

namespace sandgraph::io {

// What only a screening run has; empty otherwise.
struct ScreeningRecord {
    std::vector<std::string> reasons;  // names of stress::Reason
    std::vector<stress::Switch> switches;
    std::vector<stress::AuditRow> audits;
    bool empty() const { return reasons.empty(); }
};

// The groups /switches and /audit of run.h5, a dataset a column; none for an empty record.
void write_screening(h5::Group& root, const ScreeningRecord& record);
ScreeningRecord read_screening(const h5::Group& root);

}  // namespace sandgraph::io
