#pragma once
#include <cmath>

#include "base/tensor.hpp"

namespace sandgraph::graph {

// Frobenius norm of the 2 x 2 tensor.
inline double norm(const Stress& s) { return std::sqrt(s.xx * s.xx + s.yy * s.yy + 2 * s.xy * s.xy); }
inline void add(Stress& s, const Stress& d) { s.xx += d.xx, s.yy += d.yy, s.xy += d.xy; }
inline Stress difference(const Stress& a, const Stress& b) { return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy}; }
inline Stress scaled(double factor, const Stress& s) { return {factor * s.xx, factor * s.yy, factor * s.xy}; }
// Of the 2 x 2 tensors, double contraction.
inline double product(const Stress& a, const Stress& b) { return a.xx * b.xx + a.yy * b.yy + 2 * a.xy * b.xy; }
// Of a small increment.
inline Stress small_strain(const Mat2& F) { return {F(0, 0) - 1, F(1, 1) - 1, 0.5 * (F(0, 1) + F(1, 0))}; }

// Turns with the point by the small spin of F_inc (Jaumann).
inline void turn(Stress& s, const Mat2& F_inc) {
    const double w = 0.5 * (F_inc(1, 0) - F_inc(0, 1)), xy = s.xy, half = s.xx - s.yy;
    s.xx -= 2 * w * xy, s.yy += 2 * w * xy, s.xy += w * half;
}

}  // namespace sandgraph::graph
