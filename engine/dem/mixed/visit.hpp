#pragma once
#include "dem/fast/state.hpp"
#include "dem/mixed/list.hpp"
#include "dem/mixed/state.hpp"

namespace sandgraph::dem {

// After a move of dt whose kernel returned `rate2`: makes a stale list anew; whether it did.
bool keep_list(MixedState& state, MixedList& list, double rate2, double dt);

// `count` steps of dt under the constant gradient L: move, forces, kick. Forces and cell end in step, so the
// stress (Love-Weber, compression positive [Pa]) belongs to the deformation reached; not a number once the
// packing flies apart. `depth` is that of the cell [m].
Mat2 visit(MixedState& state, MixedList& list, const KernelConstants& k, double depth, const Mat2& L,
           double dt, int count);

}  // namespace sandgraph::dem
