#include "dem/stretch.hpp"

#include <Eigen/LU>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::dem {
namespace {

// f(U) of a symmetric 2 x 2 tensor through its principal values: U = m I + d N with N^2 = I.
template <class Function>
Mat2 isotropic(const Mat2& U, Function f) {
    const double mean = 0.5 * (U(0, 0) + U(1, 1)), half = 0.5 * (U(0, 0) - U(1, 1));
    const double shear = 0.5 * (U(0, 1) + U(1, 0)), radius = std::hypot(half, shear);
    const double major = f(mean + radius), minor = f(mean - radius);
    const double c = radius > 0 ? half / radius : 1, s = radius > 0 ? shear / radius : 0;
    const double m = 0.5 * (major + minor), d = 0.5 * (major - minor);
    return (Mat2() << m + d * c, d * s, d * s, m - d * c).finished();
}

}  // namespace

Mat2 rotation(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return (Mat2() << c, -s, s, c).finished();
}

Polar polar(const Mat2& F) {
    SG_EXPECT(F.determinant() > 0);
    // In 2D the rotation angle is closed-form: tan = (F_yx - F_xy)/(F_xx + F_yy).
    const double angle = std::atan2(F(1, 0) - F(0, 1), F(0, 0) + F(1, 1));
    const Mat2 U = rotation(-angle) * F;
    const double off = 0.5 * (U(0, 1) + U(1, 0));
    return {(Mat2() << U(0, 0), off, off, U(1, 1)).finished(), angle};
}

Mat2 hencky(const Mat2& U) {
    SG_EXPECT(U.determinant() > 0 && U.trace() > 0);
    return isotropic(U, [](double x) { return std::log(x); });
}

Mat2 root(const Mat2& U, int n) {
    SG_EXPECT(n >= 1 && U.determinant() > 0 && U.trace() > 0);
    return isotropic(U, [n](double x) { return std::exp(std::log(x) / n); });
}

Mat2 power(const Mat2& U, double exponent) {
    SG_EXPECT(U.determinant() > 0 && U.trace() > 0);
    return isotropic(U, [exponent](double x) { return std::exp(std::log(x) * exponent); });
}

}  // namespace sandgraph::dem
