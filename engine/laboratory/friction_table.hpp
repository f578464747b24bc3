#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "laboratory/soil_laboratory.hpp"

namespace sandgraph::laboratory {

// What the biaxial tests of one packing say. Late values are means over 15 to 20 % axial strain and the three
// pressures.
struct FrictionRow {
    std::string density;
    std::uint64_t seed = 0;
    double porosity = 0, coordination = 0;  // at 10 kPa
    std::array<double, 3> peak{};           // friction angle by pressure, first 10 % of strain [rad]
    double line = 0;                        // the same by one line through the origin [rad]
    double late_sin_phi = 0, late_porosity = 0, late_anisotropy = 0;  // q/p, n, F_a
};
FrictionRow friction_row(const Specimen& specimen);

// The figures of a row in the order of `kFigures`; angles in degrees.
struct Figure {
    const char *name, *heading;  // in the CSV; in the table
    int decimals;
};
inline constexpr std::array<Figure, 9> kFigures = {{{"porosity_10kPa", "n 10kPa", 4},
                                                    {"coordination_10kPa", "Z", 2},
                                                    {"peak_32kPa_deg", "32 kPa", 1},
                                                    {"peak_64kPa_deg", "64 kPa", 1},
                                                    {"peak_128kPa_deg", "128 kPa", 1},
                                                    {"peak_line_deg", "line", 1},
                                                    {"late_sin_phi", "sin phi", 3},
                                                    {"late_porosity", "n", 3},
                                                    {"late_Fa", "F_a", 3}}};
using Figures = std::array<double, kFigures.size()>;
Figures figures(const FrictionRow& row);

// Mean, standard deviation (of the sample, n - 1), least and largest of each figure.
struct Spread {
    Figures mean{}, deviation{}, least{}, largest{};
};
Spread spread(std::span<const FrictionRow> rows);

// The rows by density with mean, standard deviation and range, beside the published values, as text for
// people and as CSV (one row a specimen, then mean, sd, min and max of each density).
std::string friction_table(std::span<const FrictionRow> rows);
std::string friction_csv(std::span<const FrictionRow> rows);

}  // namespace sandgraph::laboratory
