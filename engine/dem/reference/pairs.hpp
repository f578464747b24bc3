#pragma once
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "base/tensor.hpp"

namespace sandgraph::dem {

// Two grains, j seen in the image x_j + H (cell_x, cell_y). i < j, or i == j with a positive offset.
struct PairKey {
    std::int32_t i = 0, j = 0;
    std::int16_t cell_x = 0, cell_y = 0;
    friend auto operator<=>(const PairKey&, const PairKey&) = default;
};

// A basis of the same lattice: columns of `basis` = H * change, `change` integer with determinant +1.
struct LatticeBasis {
    Mat2 basis;
    Eigen::Matrix2i change;
};

// Lagrange-Gauss reduction: the first column is a shortest lattice vector, the angle lies in [60, 120]
// degrees.
LatticeBasis reduce_lattice(const Mat2& H);

// All pairs of images with |d| < r_i + r_j + skin, sorted; right for any cell, however skewed, and for grains
// anywhere in space (positions need not lie in the cell). Linked cells in the reduced basis.
std::vector<PairKey> near_pairs(std::span<const Vec2> x, std::span<const double> r, const Mat2& H,
                                double skin);

}  // namespace sandgraph::dem
