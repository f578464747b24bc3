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

std::span<const LoadColumn> load_columns();

std::string load_csv_header();                  // without line end
std::string load_csv_line(const LoadRow& row);  // shortest text that reads back to the same bits

}  // namespace sandgraph::io
