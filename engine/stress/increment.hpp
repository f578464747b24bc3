#pragma once
#include <cmath>

#include "base/tensor.hpp"

namespace sandgraph::stress {

// Strain increment of F_inc = R U without its rotation, docs/how_it_works.md (eq. 32):
// E = 2 (U - I)(U + I)^-1, symmetric, coaxial with U, equal to ln U up to third order; exactly zero for a
// rotation, so that isotropic laws are objective at any step size.
struct Increment {
    double xx = 0, yy = 0, xy = 0;  // E, tension positive (xy is the tensor component)
    double cos = 1, sin = 0;        // R = [cos -sin; sin cos]
};

inline Increment increment(const Mat2& F) {
    const double a = F(0, 0) + F(1, 1), b = F(1, 0) - F(0, 1), n = 1 / std::sqrt(a * a + b * b);
    const double c = a * n, s = b * n;
    // U - I = R^T F - I
    const double uxx = c * F(0, 0) + s * F(1, 0) - 1, uyy = c * F(1, 1) - s * F(0, 1) - 1;
    const double uxy = 0.5 * (c * (F(0, 1) + F(1, 0)) + s * (F(1, 1) - F(0, 0)));
    const double vxx = uxx + 2, vyy = uyy + 2, k = 2 / (vxx * vyy - uxy * uxy);
    return {k * (uxx * vyy - uxy * uxy), k * (uyy * vxx - uxy * uxy), k * 2 * uxy, c, s};
}

// R sigma R^T.
inline Stress rotate(const Stress& s, double c, double sn) {
    const double mean = 0.5 * (s.xx + s.yy), half = 0.5 * (s.xx - s.yy);
    const double c2 = c * c - sn * sn, s2 = 2 * c * sn;
    const double d = c2 * half - s2 * s.xy;
    return {mean + d, mean - d, s2 * half + c2 * s.xy};
}

}  // namespace sandgraph::stress
