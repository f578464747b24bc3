#pragma once
#include <string>
#include <vector>

#include "stress/surrogate.hpp"
#include "surrogate/model.hpp"

namespace sandgraph::surrogate {

// Answers of the law on three made-up packings (low end, middle and high end of the trained traits), driven
// through compression, shear, reversal and rotation; stress over p0, rows xx, yy, xy. Stored with the model.
std::vector<double> self_test_answers(const Model& model, const stress::Surrogate& law);

// InputError when the law's answers differ from `stored` by more than 1e-9: the weights are not those that
// were saved, or the kernel is broken on this machine.
void check_self_test(const Model& model, const stress::Surrogate& law, const std::vector<double>& stored,
                     const std::string& file);

// Physics no trained model can miss, on the same packings: the secant K and G of
// a strain of 1e-7 from rest within a factor of 2.5 of the packing's own, and q/p <= 1 along 5 % of shear.
// InputError naming `file`.
void check_physics(const Model& model, const stress::Surrogate& law, const std::string& file);

}  // namespace sandgraph::surrogate
