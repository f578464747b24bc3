#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "training/history.hpp"

namespace sandgraph::training {

// Error of the stress after one step of a history: |sigma - sigma_DEM| / max(p_DEM, 1 kPa).
struct ErrorSample {
    std::int64_t history = 0;
    double strain = 0;  // length of the path so far
    double error = 0;
    double p = 0, q = 0;  // what is too much of mean stress and deviator, shares of max(p_DEM, 1 kPa)
};

// Of a regime: how many samples, their error at the 50th and 95th percentile and at worst, and the mean of
// what is too much (each within -1 and 1): scatter averages out over many points of the ground, bias does
// not.
struct ErrorRow {
    std::string regime;  // "all", "strain < 0.1 %", "path dither", ...
    std::size_t samples = 0;
    double median = 0, high = 0, worst = 0, p_bias = 0, q_bias = 0;
};

// By strain, density, pressure at the start and kind of path; regimes without a sample are left out.
std::vector<ErrorRow> error_rows(const HistorySet& set, std::span<const ErrorSample> samples);

// Errors of one law or one twin on one part of the data.
struct ErrorTable {
    std::string of, data;
    std::vector<ErrorRow> rows;
};

std::string error_text(std::span<const ErrorTable> tables);
std::string error_csv(
    std::span<const ErrorTable> tables);  // of,data,regime,samples,p50,p95,worst,p_bias,q_bias

}  // namespace sandgraph::training
