#pragma once
#include <vector>

#include "surrogate/coefficients.hpp"

namespace sandgraph::surrogate {

// One member's state at a point.
struct MemberState {
    double p = 0;                    // mean stress [Pa], compression positive
    double gamma = 0;                // accumulated plastic shear
    double strength_scale = 1;       // see coefficients()
    std::vector<Deviator> elements;  // t_k [Pa], compression positive

    Deviator deviator() const;  // s = sum t_k
};

// Mean stress never falls below this share of the starting one.
inline constexpr double pressure_floor = 1e-3;

// One return of all elements with constant coefficients: shear increment de and volume increment dv,
// compression positive. Friction |t_k| <= r_k p; slip dilates, which raises p, so p and the slips are solved
// together (two Newton iterations on a piecewise linear equation). `share` are the members' w_k, p_min [Pa].
MemberState return_map(const MemberState& state, const Coefficients& c, std::span<const double> share,
                       Deviator de, double dv, double p_min);

}  // namespace sandgraph::surrogate
