#pragma once
#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "io/h5_group.hpp"

namespace sandgraph::io {

// Mean, least and largest over the points of a region; NaN where nobody can tell.
struct Spread {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    double mean = unknown, min = unknown, max = unknown;
};

// What a region shows at one moment. Stress is compression positive.
struct RegionRow {
    double d_over_B = 0, time = 0;              // time [s]
    Spread p, q;                                // mean stress and deviator (radius of Mohr's circle) [Pa]
    Spread sigma_xx, sigma_yy, sigma_xy;        // [Pa]
    Spread K;                                   // sigma_xx/sigma_yy; its mean is that of the mean stresses
    Spread porosity, anisotropy, coordination;  // n, F_a, Z
    Spread strain, volume_strain;               // eps_eq, ln det F
    Spread rotation;                            // [rad], counter-clockwise positive
    Spread x, y;                                // where its points are [m]
};

struct RegionSeries {
    std::string name;
    int points = 0;
    std::vector<RegionRow> rows;
};

struct RegionColumn {
    const char* name;
    const char* unit;
    Spread RegionRow::*member;
};
std::span<const RegionColumn> region_columns();

// The group /regions of run.h5: a group for each region with d_over_B (N), time (N, s) and each quantity (N x
// 3: mean, min, max); none without regions.
void write_regions(h5::Group& root, const std::vector<RegionSeries>& regions);
std::vector<RegionSeries> read_regions(const h5::Group& root);

// regions.csv: region, points, d_over_B, then mean, min and max of each quantity, and the time.
std::string region_csv(const std::vector<RegionSeries>& regions);

}  // namespace sandgraph::io
