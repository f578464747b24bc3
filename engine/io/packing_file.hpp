#pragma once
#include <filesystem>
#include <string>

#include "dem/material.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::io {

// A packing with the grains' contact parameters and the recipe (TOML text) it was made by.
struct PackingRecord {
    dem::Packing packing;
    dem::Material material;
    std::string recipe;
};

// HDF5: /cell/H, /cell/L (2x2), /grains/{x,y,r[,vx,vy,spin]} with units, /contacts/{i,j,cell_x,cell_y,
// tangential,moment}, material as attributes of /material, recipe as an attribute of the root. Atomic.
void write_packing(const std::filesystem::path& path, const PackingRecord& record);

// Reading gives back the same bits. InputError on what dem::check_packing refuses, on arrays of different
// lengths, on contacts outside the packing and on a material that is no material.
PackingRecord read_packing(const std::filesystem::path& path);

}  // namespace sandgraph::io
