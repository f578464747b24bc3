#pragma once
#include "base/tensor.hpp"

namespace sandgraph::graph {

// Isotropic small-strain stiffness of a packing in the plane [Pa]: s = K tr(e) I + 2 G dev(e).
struct PlaneModuli {
    double bulk = 0, shear = 0;
    double p_wave() const { return bulk + shear; }
};

// Stress change of the small increment F_inc [Pa], tension positive, without its rotation: the elastic part
// of docs/how_it_works.md (eq. 29).
inline Stress elastic_change(const PlaneModuli& m, const Mat2& F_inc) {
    const double xx = F_inc(0, 0) - 1, yy = F_inc(1, 1) - 1, xy = 0.5 * (F_inc(0, 1) + F_inc(1, 0));
    const double mean = m.bulk * (xx + yy), half = m.shear * (xx - yy);
    return {mean + half, mean - half, 2 * m.shear * xy};
}

}  // namespace sandgraph::graph
