#include "dem/packing/cell_reduction.hpp"

#include <Eigen/LU>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::dem {

Reduction reduce_cell(const Mat2& H) {
    SG_EXPECT(H.determinant() != 0);
    // Leave a cell alone until it is clearly skewed, so that noise does not flip it to and fro.
    constexpr double kHysteresis = 0.05;
    Reduction r;
    Vec2 a = H.col(0), b = H.col(1);
    for (int pass = 0; pass < 100; ++pass) {
        const bool shear_b = b.squaredNorm() >= a.squaredNorm();
        const Vec2& shorter = shear_b ? a : b;
        const double ratio = a.dot(b) / shorter.squaredNorm();
        if (std::abs(ratio) <= 0.5 + kHysteresis) break;
        const int k = static_cast<int>(std::lround(ratio));
        if (shear_b) {
            b -= k * a;
            r.U.col(1) -= k * r.U.col(0);
        } else {
            a -= k * b;
            r.U.col(0) -= k * r.U.col(1);
        }
        r.identity = false;
    }
    r.U_inverse << r.U(1, 1), -r.U(0, 1), -r.U(1, 0), r.U(0, 0);  // det U = 1
    SG_ENSURE(r.U * r.U_inverse == Eigen::Matrix2i::Identity());
    return r;
}

}  // namespace sandgraph::dem
