#pragma once
#include <string>
#include <vector>

#include "scene/sweep_spec.hpp"

namespace sandgraph::scene {

struct SweepRow {
    std::string name;                // a folder's: "embedment_ratio=2_density=dense", or as the CSV says
    std::vector<SweepValue> values;  // of the table's keys
    InputError::Where where;
};

// A table, row by row.
struct SweepTable {
    SweepSpec spec;
    std::vector<std::string> keys;  // all that are varied, in the order of the table
    // Of those the first of each axis: the others go along with them.
    std::vector<std::size_t> axes;
    std::vector<SweepRow> rows;

    std::vector<std::string> overrides(const SweepRow& row) const;  // "section.key=value", as of --set
};

// Every key is one of a scene, every value one that it may have, no two rows have the same name. Throws
// InputError at the line of the table. Whether a row as a whole is a scene that can be run: simulation/sweep.
SweepTable read_sweep_table(const std::string& file);

}  // namespace sandgraph::scene
