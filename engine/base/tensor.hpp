#pragma once
#include <Eigen/Core>

#include <cmath>

// Tensor and sign conventions, stated once. SI units. Plane strain: tensors are 2 x 2.
// L_ij = dv_i/dx_j; an increment is F_inc = I + dt L.
namespace sandgraph {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

// Cauchy stress of a material point [Pa], tension positive, symmetric part only (MPM convention).
struct Stress {
    double xx = 0, yy = 0, xy = 0;
    friend bool operator==(const Stress&, const Stress&) = default;
};

// The one place where the sign convention changes: grains and soil reports are compression positive.
// `compression` [Pa] is the (possibly not symmetric) Love-Weber stress, compression positive.
inline Stress tension_positive(const Mat2& compression) {
    return {-compression(0, 0), -compression(1, 1), -0.5 * (compression(0, 1) + compression(1, 0))};
}
inline Mat2 compression_positive(const Stress& s) {
    return (Mat2() << -s.xx, -s.xy, -s.xy, -s.yy).finished();
}

// Mean stress p = (s_xx + s_yy)/2 [Pa] and deviator q = radius of Mohr's circle [Pa], both compression
// positive.
inline double mean_stress(const Stress& s) { return -0.5 * (s.xx + s.yy); }
inline double deviator(const Stress& s) { return std::hypot(0.5 * (s.xx - s.yy), s.xy); }

}  // namespace sandgraph
