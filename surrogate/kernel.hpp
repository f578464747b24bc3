#pragma once
#include <string>
#include <vector>

#include "stress/surrogate.hpp"
#include "surrogate/kernel_model.hpp"

namespace sandgraph::surrogate {

// Reference::update, vectorised over the points and dispatched at run time to the widest instruction set of
// the machine. Agrees with it to 1e-12; a point's bits do not depend on the other points of the batch.
// `points` [n] are ids, each once; `F_inc` and `states` (layout.size() numbers a point) are by id, `answers`
// [n] in the order of `points`. Increments must have det F > 0.
void serve(const KernelModel& kernel, std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
           std::span<double> states, std::span<stress::SurrogateAnswer> answers);

std::vector<std::int64_t> kernel_targets();  // instruction sets this machine can serve with
std::string kernel_target();                 // the instruction set in use, e.g. "AVX3"

}  // namespace sandgraph::surrogate
