#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::mpm {

// Weights of three successive nodes base, base + 1, base + 2 along one axis.
struct Weights {
    int base = 0;
    std::array<double, 3> S{};   // sum 1
    std::array<double, 3> dS{};  // d/dx [1/m], sum 0
};

// Uniform GIMP (Bardenhagen & Kober 2004) from the linear hat N of the grid, averaged over the interval [a,
// b] of at most one cell: S_i = int_a^b N_i dx / (b - a), dS_i/dx = (N_i(b) - N_i(a)) / (b - a). `a`, `b` [m]
// from the grid's origin. With t in cells from the base node, N_0 = max(0, 1 - t), N_2 = max(0, t - 1).
inline Weights average(double a, double b, double cell) {  // docs/how_it_works.md (eq. 2)
    SG_EXPECT(b > a && b - a <= cell * (1 + 1e-9));
    Weights w;
    const double cells = std::floor(a / cell);
    w.base = static_cast<int>(cells);
    const double ta = a / cell - cells, width = (b - a) / cell, tb = ta + width;
    const double na = 1 - ta, nb = std::max(0.0, 1 - tb), mb = std::max(0.0, tb - 1);
    w.S[0] = 0.5 * (na + nb) * (std::min(width, na) / width);
    w.S[2] = 0.5 * mb * mb / width;
    w.S[1] = 1 - w.S[0] - w.S[2];
    w.dS[0] = (nb - na) / (b - a);
    w.dS[2] = mb / (b - a);
    w.dS[1] = -(w.dS[0] + w.dS[2]);
    SG_ENSURE(w.S[0] >= 0 && w.S[1] >= -1e-9 && w.S[2] >= 0);
    return w;
}

// The hat functions themselves at one coordinate [m] from the grid's origin (dS unset).
inline Weights at(double a, double cell) {
    SG_EXPECT(cell > 0);
    Weights w;
    const double cells = std::floor(a / cell);
    w.base = static_cast<int>(cells);
    w.S[1] = a / cell - cells;
    w.S[0] = 1 - w.S[1];
    return w;
}

}  // namespace sandgraph::mpm
