#include "mpm/kinematics.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace sandgraph::mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Mat2 logarithmic_strain(const Mat2& F) {
    if (!(F.determinant() > 0)) return Mat2::Constant(nan);
    // C = F^T F = U^2, so ln U = (1/2) sum ln(c_k) n_k (x) n_k.
    Eigen::SelfAdjointEigenSolver<Mat2> C;
    C.computeDirect(F.transpose() * F);
    return 0.5 * C.eigenvectors() * C.eigenvalues().array().log().matrix().asDiagonal() *
           C.eigenvectors().transpose();
}

double equivalent_strain(const Mat2& F) {  // docs/how_it_works.md (eq. 12)
    const Mat2 eps = logarithmic_strain(F);
    const double third = eps.trace() / 3;
    const Mat2 in_plane = eps - third * Mat2::Identity();
    return std::sqrt(2.0 / 3.0 * (in_plane.squaredNorm() + third * third));
}

double rotation(const Mat2& F) {  // (eq. 12)
    if (!(F.determinant() > 0)) return nan;
    return std::atan2(F(1, 0) - F(0, 1), F(0, 0) + F(1, 1));
}

double volumetric_strain(const Mat2& F) {  // (eq. 12)
    const double J = F.determinant();
    return J > 0 ? std::log(J) : nan;
}

}  // namespace sandgraph::mpm
