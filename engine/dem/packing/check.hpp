#pragma once
#include <span>
#include <string>

#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// Where a packing came from, for error messages: the file, the line of the cell, the line of each grain.
struct PackingSource {
    std::string file;
    int cell_line = 0;
    std::span<const int> grain_lines;  // may be empty
};

// Refuses what no packing can be: not finite, r <= 0, a singular or inverted cell, a cell smaller than its
// grains, overlaps of more than half the smaller radius (over periodic images too). Throws InputError.
void check_packing(const Packing& packing, const PackingSource& source);

}  // namespace sandgraph::dem
