#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <tuple>

#include "base/random.hpp"
#include "dem/fast/neighbours.hpp"

namespace sandgraph::dem {
namespace {

struct Cloud {
    Mat2 H;
    std::vector<double> records;  // as of FastState
    int n = 0;
};

Cloud random_cloud(std::uint64_t seed, int n, const Mat2& H) {
    Random random(seed);
    Cloud c{H, {}, n};
    for (int g = 0; g < n; ++g) {
        const Vec2 x = H * Vec2(random.uniform(), random.uniform());
        c.records.insert(c.records.end(), {x.x(), x.y(), 0, 0, random.uniform(0.003, 0.007), 0, 0, 0});
    }
    return c;
}

using Key = std::tuple<int, int, int, int>;

std::vector<Key> sorted(const std::vector<NearPair>& pairs) {
    std::vector<Key> out;
    for (const NearPair& p : pairs) out.emplace_back(p.i, p.j, p.cell_x, p.cell_y);
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<Key> all_pairs(const Cloud& c, double gap) {
    std::vector<Key> out;
    for (int i = 0; i < c.n; ++i)
        for (int j = i + 1; j < c.n; ++j)
            for (int cx = -1; cx <= 1; ++cx)
                for (int cy = -1; cy <= 1; ++cy) {
                    const Vec2 s = c.H * Vec2(cx, cy);
                    const double *a = &c.records[8 * i], *b = &c.records[8 * j];
                    const double d = std::hypot(b[0] + s.x() - a[0], b[1] + s.y() - a[1]);
                    if (d < a[4] + b[4] + gap) out.emplace_back(i, j, cx, cy);
                }
    std::sort(out.begin(), out.end());
    return out;
}

TEST(NeighbourSearch, FindsWhatBruteForceFindsInAnyCell) {
    Random random(7);
    for (int trial = 0; trial < 40; ++trial) {
        const Mat2 H = (Mat2() << random.uniform(0.08, 0.3), random.uniform(-0.04, 0.04),
                        random.uniform(-0.02, 0.02), random.uniform(0.08, 0.3))
                           .finished();
        const Cloud c = random_cloud(100 + trial, 150, H);
        NeighbourSearch search;
        EXPECT_EQ(sorted(search.find(c.records.data(), c.n, H, 5e-4)), all_pairs(c, 5e-4));
    }
}

TEST(CellReduction, KeepsTheLatticeAndShortensThePeriods) {
    Random random(3);
    int reduced_cells = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Mat2 H = (Mat2() << 0.2, random.uniform(-3, 3), random.uniform(-0.05, 0.05), 0.2).finished();
        if (H.determinant() < 1e-3) continue;
        ++reduced_cells;
        const Reduction r = reduce_cell(H);
        EXPECT_EQ(r.U.determinant(), 1);
        EXPECT_EQ(Eigen::Matrix2i(r.U * r.U_inverse), Eigen::Matrix2i::Identity());
        const Mat2 reduced = H * r.U.cast<double>();
        EXPECT_NEAR(reduced.determinant(), H.determinant(), 1e-12);
        EXPECT_LE(std::abs(reduced.col(0).dot(reduced.col(1))),
                  0.551 * std::min(reduced.col(0).squaredNorm(), reduced.col(1).squaredNorm()));
    }
    EXPECT_GT(reduced_cells, 100);
}

}  // namespace
}  // namespace sandgraph::dem
