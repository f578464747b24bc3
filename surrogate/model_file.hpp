#pragma once
#include <filesystem>
#include <vector>

#include "surrogate/model.hpp"

namespace sandgraph::surrogate {

// A model with the answers of its self test.
struct ModelRecord {
    Model model;
    std::vector<double> self_test;
};

// HDF5 behind a checksum of all bytes: attributes of the root for the scalars, /features/{low,high}, and for
// each member /member_i/{share,strength,dilatancy} and /member_i/layer_j/{weight,bias}, /self_test. Atomic.
// InputError when check_model refuses the model.
void write_model(const std::filesystem::path& path, const Model& model);

// InputError when the file is missing, truncated, damaged, of another content, schema or feature version, or
// its numbers are refused by check_model.
ModelRecord read_model(const std::filesystem::path& path);

}  // namespace sandgraph::surrogate
