#pragma once
#include <span>
#include <string>
#include <vector>

#include "io/frame.hpp"

namespace sandgraph::io {

// The columns of the load series, stated once for load.csv, run.h5 and the pictures.
struct LoadColumn {
    const char* dataset;  // below /load of run.h5
    const char* header;   // of load.csv
    const char* unit;
    double LoadRow::*member;
};

// `audited`: of runs whose law audits its load, which have more.
std::span<const LoadColumn> load_columns(bool audited = false);

std::string load_csv_header(bool audited = false);  // without line end
// Shortest text that reads back to the same bits.
std::string load_csv_line(const LoadRow& row, bool audited = false);

}  // namespace sandgraph::io
