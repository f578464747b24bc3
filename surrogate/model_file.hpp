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

// What no trained model can be, InputError naming `file`: another feature version, wrong shapes, NaN or
// infinity, and magnitudes outside these: 1 to 16 elements and members, layers up to 128 wide, weights up to
// 1000, substep 1e-6 to 1e-2, bounds 1 to 5, K/K0 0.02 to 5 with its bound, exponent 0 to 1, shares positive
// with sum 1, friction limits positive with sum at most 1 (q = p), |dilatancy| up to 5.
void check_model(const Model& model, const std::string& file);

}  // namespace sandgraph::surrogate
