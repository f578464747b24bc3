#pragma once
#include <string>

#include "surrogate/model.hpp"

namespace sandgraph::surrogate {

// What no trained model can be, InputError naming `file`: another feature version, wrong shapes, NaN or
// infinity, and magnitudes outside these: 1 to 16 elements and members, layers up to 128 wide, weights up to
// 1000, substep 1e-6 to 1e-2, bounds 1 to 5, K/K0 0.02 to 5 with its bound, exponent 0 to 1, shares positive
// with sum 1, friction limits positive with sum at most 1 (q = p), |dilatancy| up to 5.
void check_model(const Model& model, const std::string& file);

}  // namespace sandgraph::surrogate
