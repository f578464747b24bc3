#include "dem/reference/pairs.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::dem {
namespace {

using Cell = Eigen::Vector2i;

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

// Grains sorted into bins of the reduced cell; bins are at least as wide as needed for `range` bins a side.
struct Bins {
    Cell count, range;
    std::vector<Cell> bin_of, image_of;  // by grain: its bin, and the lattice cell it lies in
    std::vector<std::vector<std::int32_t>> members;

    std::vector<std::int32_t>& at(const Cell& b) {
        return members[static_cast<std::size_t>(b.y() * count.x() + b.x())];
    }
};

void size_bins(Bins& bins, const Mat2& basis, double cutoff, std::size_t grains) {
    const int most = 1 + static_cast<int>(std::sqrt(static_cast<double>(grains)));
    for (int k = 0; k < 2; ++k) {
        const double height = basis.determinant() / basis.col(1 - k).norm();
        bins.count[k] = std::clamp(static_cast<int>(std::min(height / cutoff, 1e6)), 1, most);
        bins.range[k] = static_cast<int>(std::ceil(cutoff * bins.count[k] / height));
    }
    bins.members.resize(static_cast<std::size_t>(bins.count.prod()));
}

Bins sort_grains(std::span<const Vec2> x, const Mat2& basis, double cutoff) {
    Bins bins;
    size_bins(bins, basis, cutoff, x.size());
    const Mat2 inverse = basis.inverse();
    for (std::size_t g = 0; g < x.size(); ++g) {
        const Vec2 s = inverse * x[g];
        const Cell image = s.array().floor().cast<int>();
        const Vec2 inside = s - image.cast<double>();
        Cell bin;
        for (int k = 0; k < 2; ++k)
            bin[k] = std::min(static_cast<int>(inside[k] * bins.count[k]), bins.count[k] - 1);
        bins.image_of.push_back(image);
        bins.bin_of.push_back(bin);
        bins.at(bin).push_back(static_cast<std::int32_t>(g));
    }
    return bins;
}

bool counted_once(const PairKey& key) {
    return key.i < key.j || (key.i == key.j && (key.cell_x > 0 || (key.cell_x == 0 && key.cell_y > 0)));
}

struct Search {
    std::span<const Vec2> x;
    std::span<const double> r;
    const Mat2& H;
    LatticeBasis lattice;
    double skin;

    void try_pair(std::int32_t i, std::int32_t j, const Cell& offset, std::vector<PairKey>& out) const {
        const Cell c = lattice.change * offset;
        const PairKey key{i, j, static_cast<std::int16_t>(c.x()), static_cast<std::int16_t>(c.y())};
        if (!counted_once(key)) return;
        const Vec2 d = x[j] + H * c.cast<double>() - x[i];
        const double cutoff = r[i] + r[j] + skin;
        if (d.squaredNorm() < cutoff * cutoff) out.push_back(key);
    }
    void around(std::int32_t i, Bins& bins, std::vector<PairKey>& out) const {
        for (int b = -bins.range.y(); b <= bins.range.y(); ++b)
            for (int a = -bins.range.x(); a <= bins.range.x(); ++a) {
                const Cell raw = bins.bin_of[i] + Cell(a, b);
                const Cell image(floor_div(raw.x(), bins.count.x()), floor_div(raw.y(), bins.count.y()));
                const Cell home = raw - image.cwiseProduct(bins.count);
                for (std::int32_t j : bins.at(home))
                    try_pair(i, j, image - bins.image_of[j] + bins.image_of[i], out);
            }
    }
};

}  // namespace

LatticeBasis reduce_lattice(const Mat2& H) {
    SG_EXPECT(H.determinant() != 0);
    LatticeBasis out{H, Eigen::Matrix2i::Identity()};
    for (;;) {
        if (out.basis.col(0).squaredNorm() > out.basis.col(1).squaredNorm()) {
            out.basis = (Mat2() << out.basis.col(1), -out.basis.col(0)).finished();
            out.change = (Eigen::Matrix2i() << out.change.col(1), -out.change.col(0)).finished();
        }
        const double m = std::round(out.basis.col(0).dot(out.basis.col(1)) / out.basis.col(0).squaredNorm());
        if (m == 0) return out;
        LatticeBasis next = out;
        next.change.col(1) -= static_cast<int>(m) * out.change.col(0);
        next.basis = H * next.change.cast<double>();
        // Of two equally short bases each leads to the other, for ever (found by fuzzing).
        if (next.basis.col(1).squaredNorm() > (1 - 1e-12) * out.basis.col(1).squaredNorm()) return out;
        out = next;
    }
}

std::vector<PairKey> near_pairs(std::span<const Vec2> x, std::span<const double> r, const Mat2& H,
                                double skin) {
    SG_EXPECT(x.size() == r.size() && skin >= 0);
    std::vector<PairKey> pairs;
    if (x.empty()) return pairs;
    const Search search{x, r, H, reduce_lattice(H), skin};
    const double cutoff = 2 * *std::max_element(r.begin(), r.end()) + skin;
    Bins bins = sort_grains(x, search.lattice.basis, cutoff);
    for (std::size_t i = 0; i < x.size(); ++i) search.around(static_cast<std::int32_t>(i), bins, pairs);
    std::sort(pairs.begin(), pairs.end());
    SG_ENSURE(std::ranges::adjacent_find(pairs) == pairs.end());  // each once
    return pairs;
}

}  // namespace sandgraph::dem
