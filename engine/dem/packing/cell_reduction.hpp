#pragma once
#include <Eigen/Core>

#include "base/tensor.hpp"

namespace sandgraph::dem {

// Change of lattice basis H' = H U with U integer and det U = 1 (Lagrange-Gauss reduction): H' spans the same
// periodic packing with the shortest periods, |a1 . a2| <= min(|a1|^2, |a2|^2)/2. Image counters become U^-1
// c.
struct Reduction {
    Eigen::Matrix2i U = Eigen::Matrix2i::Identity();
    Eigen::Matrix2i U_inverse = Eigen::Matrix2i::Identity();
    bool identity = true;
};
Reduction reduce_cell(const Mat2& H);

}  // namespace sandgraph::dem
