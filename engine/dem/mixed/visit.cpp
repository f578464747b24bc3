#include "dem/mixed/visit.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "base/contracts.hpp"
#include "dem/mixed/kernel.hpp"

namespace sandgraph::dem {

// A new list comes with a new basis of the cell: the grains are laid out in it.
bool keep_list(MixedState& s, MixedList& list, double rate2, double dt) {
    if (!list.moved(s, rate2, dt)) return false;
    list.rebuild(s);
    drift(s, s.packing.L, 0);
    return true;
}

Mat2 visit(MixedState& s, MixedList& list, const KernelConstants& k, double depth, const Mat2& L, double dt,
           int count) {
    SG_EXPECT(count >= 1 && dt > 0 && depth > 0);
    double sum[4], rate2 = drift(s, L, dt);
    keep_list(s, list, rate2, dt);
    for (int step = 1; step < count; ++step) {
        contact_forces(s, k, dt, nullptr);
        rate2 = kick_drift(s, k, L, dt);
        keep_list(s, list, rate2, dt);
    }
    contact_forces(s, k, dt, sum);
    rate2 = kick(s, k, dt);
    if (!std::isfinite(rate2)) return Mat2::Constant(std::numeric_limits<double>::quiet_NaN());
    return (Mat2() << sum[0], sum[1], sum[2], sum[3]).finished() / (s.packing.H.determinant() * depth);
}

}  // namespace sandgraph::dem
