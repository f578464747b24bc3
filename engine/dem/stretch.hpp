#pragma once
#include "base/tensor.hpp"

namespace sandgraph::dem {

// Polar decomposition F = R U of a deformation gradient with det F > 0: R turns by `angle` [rad].
struct Polar {
    Mat2 U;
    double angle;
};
Polar polar(const Mat2& F);

Mat2 rotation(double angle);

// log U of a symmetric positive-definite stretch (Hencky strain), and U^(1/n).
Mat2 hencky(const Mat2& U);
Mat2 root(const Mat2& U, int n);
Mat2 power(const Mat2& U, double exponent);  // U^exponent

// Turns a tensor given in the rotated frame into the fixed one: R s R^T.
inline Mat2 turned(const Mat2& s, double angle) {
    const Mat2 R = rotation(angle);
    return R * s * R.transpose();
}

}  // namespace sandgraph::dem
