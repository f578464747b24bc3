// The Verlet list of the reference assembly: when it stays valid, how it is rebuilt, how history is carried
// over.
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "dem/reference/reference.hpp"

namespace sandgraph::dem {
namespace {

// Spectral norm of a 2x2 matrix.
double norm2(const Mat2& a) {
    const double half = 0.5 * a.squaredNorm(), det = a.determinant();
    return std::sqrt(half + std::sqrt(std::max(0.0, half * half - det * det)));
}

}  // namespace

// A pair that touches now, |d| < r_i + r_j, lay at |d_0| <= |F^-1| (|d| + 2 u) when the list was built (u:
// largest non-affine displacement), so it is listed as long as this stays below r_i + r_j + skin; large
// grains are worst.
bool ReferenceAssembly::list_is_valid(double fluctuation) const {
    const double stretch = std::max(1.0, norm2(listed_F_.inverse()));
    return stretch * (2 * r_max_ + 2 * fluctuation) <= 2 * r_max_ + skin_;
}

// The running bound adds up the largest speeds; the exact displacement is found only when the bound is used
// up.
void ReferenceAssembly::refresh_pairs() {
    if (list_is_valid(fluctuation_bound_)) return;
    fluctuation_bound_ = largest_fluctuation();
    if (!list_is_valid(1.1 * fluctuation_bound_)) rebuild_pairs();
}

double ReferenceAssembly::largest_fluctuation() const {
    double squared = 0;
    for (std::size_t g = 0; g < x_.size(); ++g)
        squared = std::max(squared, (x_[g] - listed_F_ * listed_x_[g]).squaredNorm());
    return std::sqrt(squared);
}

void ReferenceAssembly::rebuild_pairs() {
    std::vector<Pair> old = std::move(pairs_);
    pairs_.clear();
    auto next = old.begin();
    for (const PairKey& key : near_pairs(x_, r_, H_, skin_)) {
        next = std::find_if(next, old.end(), [&](const Pair& p) { return p.key >= key; });
        const bool known = next != old.end() && next->key == key;
        pairs_.push_back(known ? *next
                               : Pair{key, PairConstants(r_[key.i], r_[key.j], material_), {}, false});
    }
    listed_x_ = x_;
    listed_F_.setIdentity();
    fluctuation_bound_ = 0;
}

void ReferenceAssembly::restore_history(const std::vector<Contact>& contacts) {
    for (const Contact& c : contacts) {
        const PairKey key{c.i, c.j, c.cell_x, c.cell_y};
        const auto it = std::ranges::lower_bound(pairs_, key, {}, &Pair::key);
        if (it == pairs_.end() || it->key != key) continue;
        it->touch.touching = it->restored = true;
        it->touch.f_t = {c.tangential, 0};
        it->touch.rolling = c.moment;
    }
}

}  // namespace sandgraph::dem
