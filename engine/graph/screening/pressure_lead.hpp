#pragma once
#include <algorithm>
#include <cmath>

#include "base/tensor.hpp"

namespace sandgraph::graph {

// An auditor's packing is driven along its point's strain, but its volume gives way until its mean stress is
// the ground's. Under given strain alone a packing that dilates otherwise than the surrogate locks or
// loosens, and its stress says more of that than of what the ground lacks: sand in the ground would have
// given way: docs/how_it_works.md (eq. 41b).
inline constexpr double giving_way_max = 5e-4;  // volume strain of one piece

// Volume strain, opening positive, that takes off the packing's `excess` of mean stress [Pa] elastically.
// `bulk`: at the pressure `at` [Pa]; grows with the root of it.
inline double giving_way(double excess, double bulk, double at, double p) {
    return std::clamp(excess / (bulk * std::sqrt(p / at)), -giving_way_max, giving_way_max);
}

inline Mat2 opened(const Mat2& F_inc, double volume_strain) { return (1 + 0.5 * volume_strain) * F_inc; }

}  // namespace sandgraph::graph
