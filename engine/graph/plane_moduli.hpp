#pragma once
#include "base/tensor.hpp"

namespace sandgraph::graph {

// Isotropic small-strain stiffness of a packing in the plane [Pa]: s = K tr(e) I + 2 G dev(e).
struct PlaneModuli {
    double bulk = 0, shear = 0;
    double p_wave() const { return bulk + shear; }
};

// Of the small strain e [Pa], both tension positive.
inline Stress elastic_stress(const PlaneModuli& m, const Stress& e) {
    const double mean = m.bulk * (e.xx + e.yy), half = m.shear * (e.xx - e.yy);
    return {mean + half, mean - half, 2 * m.shear * e.xy};
}

// Stress change of the small increment F_inc [Pa], tension positive, without its rotation: the elastic part
// of docs/how_it_works.md (eq. 29).
inline Stress elastic_change(const PlaneModuli& m, const Mat2& F_inc) {
    return elastic_stress(m, {F_inc(0, 0) - 1, F_inc(1, 1) - 1, 0.5 * (F_inc(0, 1) + F_inc(1, 0))});
}

}  // namespace sandgraph::graph
