#pragma once
#include <cmath>

#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {

// Larger principal stress [Pa], tension positive.
inline double largest_tension(const Stress& s) {
    return 0.5 * (s.xx + s.yy) + std::hypot(0.5 * (s.xx - s.yy), s.xy);
}

// What of a fading jump sand can bear on top of the stress of the law that answers: all, a half, a quarter
// ... or nothing, such that nothing pulls.
inline Stress bearable(const Stress& answered, Stress rest) {
    for (int halvings = 0; halvings < 6; ++halvings) {
        Stress sum = answered;
        add(sum, rest);
        if (largest_tension(sum) <= 0) return rest;
        rest = {0.5 * rest.xx, 0.5 * rest.yy, 0.5 * rest.xy};
    }
    return {};
}

}  // namespace sandgraph::graph
