#include "dem/fast/neighbours.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "dem/fast/state.hpp"

namespace sandgraph::dem {
namespace {

constexpr int kRecord = FastState::kRecord, kRadius = 4;

double largest_radius(const double* grains, int count) {
    double out = 0;
    for (int g = 0; g < count; ++g) out = std::max(out, grains[kRecord * g + kRadius]);
    return out;
}

bool near(const double* a, const double* b, double sx, double sy, double gap) {
    const double dx = b[0] + sx - a[0], dy = b[1] + sy - a[1], most = a[kRadius] + b[kRadius] + gap;
    return dx * dx + dy * dy < most * most;
}

// The half of the 3 x 3 neighbourhood that meets every pair of bins once; (0, 0) comes first.
constexpr int kHalf[5][2] = {{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};

int wrapped_bin(int b, int n, int& period) {
    period = b < 0 ? -1 : (b >= n ? 1 : 0);
    return b - period * n;
}

}  // namespace

Wrapped wrap(const Mat2& H, const Mat2& H_inverse, double& x, double& y) {
    const Vec2 s = H_inverse * Vec2(x, y);
    const Wrapped c{static_cast<int>(std::floor(s.x())), static_cast<int>(std::floor(s.y()))};
    x -= H(0, 0) * c.cx + H(0, 1) * c.cy;
    y -= H(1, 0) * c.cx + H(1, 1) * c.cy;
    return c;
}

const std::vector<NearPair>& NeighbourSearch::find(const double* grains, int count, const Mat2& H,
                                                   double gap) {
    SG_EXPECT(grains != nullptr && count >= 0 && gap >= 0);
    SG_EXPECT(H.determinant() != 0);
    pairs_.clear();
    const double cutoff = 2 * largest_radius(grains, count) + gap;
    const double area = std::abs(H.determinant());
    // Perpendicular heights of the cell, in bins of at least the cut-off.
    nx_ = static_cast<int>(area / H.col(1).norm() / cutoff);
    ny_ = static_cast<int>(area / H.col(0).norm() / cutoff);
    if (nx_ < 3 || ny_ < 3) {
        brute_force(grains, count, H, gap);
        return pairs_;
    }
    bin(grains, count, H);
    for (int bx = 0; bx < nx_; ++bx)
        for (int by = 0; by < ny_; ++by) pairs_of_bin(grains, H, gap, bx, by);
    return pairs_;
}

// Counting sort of the grains by bin; within a bin by id.
void NeighbourSearch::bin(const double* grains, int count, const Mat2& H) {
    const Mat2 inverse = H.inverse();
    start_.assign(nx_ * ny_ + 1, 0);
    bin_of_.resize(count);
    member_.resize(count);
    for (int g = 0; g < count; ++g) {
        const Vec2 s = inverse * Vec2(grains[kRecord * g], grains[kRecord * g + 1]);
        const int bx = std::clamp(static_cast<int>(s.x() * nx_), 0, nx_ - 1);
        const int by = std::clamp(static_cast<int>(s.y() * ny_), 0, ny_ - 1);
        bin_of_[g] = bx * ny_ + by;
        ++start_[bin_of_[g] + 1];
    }
    for (int b = 0; b < nx_ * ny_; ++b) start_[b + 1] += start_[b];
    for (int g = 0; g < count; ++g) member_[start_[bin_of_[g]]++] = g;
    std::rotate(start_.begin(), start_.end() - 1, start_.end());  // start_[b] ran on to the start of b + 1
    start_[0] = 0;
}

void NeighbourSearch::pairs_of_bin(const double* grains, const Mat2& H, double gap, int bx, int by) {
    for (const auto& [ox, oy] : kHalf) {
        int px, py;
        const int other = wrapped_bin(bx + ox, nx_, px) * ny_ + wrapped_bin(by + oy, ny_, py),
                  own = bx * ny_ + by;
        const double sx = H(0, 0) * px + H(0, 1) * py, sy = H(1, 0) * px + H(1, 1) * py;
        for (int m = start_[own]; m < start_[own + 1]; ++m) {
            const int i = member_[m];
            for (int k = own == other ? m + 1 : start_[other]; k < start_[other + 1]; ++k) {
                const int j = member_[k];
                if (near(grains + kRecord * i, grains + kRecord * j, sx, sy, gap))
                    pairs_.push_back(i < j ? NearPair{i, j, std::int8_t(px), std::int8_t(py)}
                                           : NearPair{j, i, std::int8_t(-px), std::int8_t(-py)});
            }
        }
    }
}

// Packings so small that the cell is fewer than three bins wide: every pair and every image.
void NeighbourSearch::brute_force(const double* grains, int count, const Mat2& H, double gap) {
    for (int i = 0; i < count; ++i)
        for (int j = i; j < count; ++j)
            for (int image = 0; image < 9; ++image) {
                const int cx = image / 3 - 1, cy = image % 3 - 1;
                if (i == j && (cx < 0 || (cx == 0 && cy <= 0))) continue;
                const Vec2 shift = H * Vec2(cx, cy);
                if (near(grains + kRecord * i, grains + kRecord * j, shift.x(), shift.y(), gap))
                    pairs_.push_back({i, j, std::int8_t(cx), std::int8_t(cy)});
            }
}

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
