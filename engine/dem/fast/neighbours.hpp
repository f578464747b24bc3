#pragma once
#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "base/tensor.hpp"

namespace sandgraph::dem {

// A pair (i < j, or i = j with another image) whose gap is below the search distance.
struct NearPair {
    std::int32_t i, j;
    std::int8_t cell_x, cell_y;
};

// Linear-time search for near pairs in a periodic cell; reusable so that a search allocates nothing.
class NeighbourSearch {
  public:
    // All pairs with |x_j + H c - x_i| < r_i + r_j + gap, each once, i <= j. `grains` are records of the
    // working state (dem/fast/state.hpp), centres wrapped into the cell. Images c in {-1, 0, 1}^2.
    const std::vector<NearPair>& find(const double* grains, int count, const Mat2& H, double gap);

  private:
    void bin(const double* grains, int count, const Mat2& H);
    void pairs_of_bin(const double* grains, const Mat2& H, double gap, int bx, int by);
    void brute_force(const double* grains, int count, const Mat2& H, double gap);

    int nx_ = 0, ny_ = 0;
    std::vector<int> start_, member_, bin_of_;
    std::vector<NearPair> pairs_;
};

// Moves a centre into the cell (fractional coordinates in [0, 1)); returns how many periods were taken off.
struct Wrapped {
    int cx, cy;
};
Wrapped wrap(const Mat2& H, const Mat2& H_inverse, double& x, double& y);

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
