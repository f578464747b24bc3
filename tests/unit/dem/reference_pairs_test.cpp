#include "dem/reference/pairs.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace sandgraph::dem {
namespace {

struct Scene {
    std::string name;
    Mat2 H;
    int grains;
};

Mat2 cell(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }

std::vector<Vec2> scattered(const Mat2& H, int grains, double spread) {
    Random random(7);
    std::vector<Vec2> x;
    for (int g = 0; g < grains; ++g) {
        const double a = random.uniform(-spread, spread), b = random.uniform(-spread, spread);
        x.push_back(H * Vec2(a, b));
    }
    return x;
}

// Every image within `range` periods, counted from the grains' own positions.
std::vector<PairKey> all_images(const std::vector<Vec2>& x, const std::vector<double>& r, const Mat2& H,
                                double skin, int range) {
    std::vector<PairKey> found;
    const int n = static_cast<int>(x.size());
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j)
            for (int a = -range; a <= range; ++a)
                for (int b = -range; b <= range; ++b) {
                    if (i == j && (a < 0 || (a == 0 && b <= 0))) continue;
                    const Vec2 d = x[j] + H * Vec2(a, b) - x[i];
                    const double reach = r[i] + r[j] + skin;
                    if (d.squaredNorm() < reach * reach)
                        found.push_back({i, j, static_cast<std::int16_t>(a), static_cast<std::int16_t>(b)});
                }
    std::sort(found.begin(), found.end());
    return found;
}

class NearPairs : public testing::TestWithParam<Scene> {};

TEST_P(NearPairs, AreThoseOfBruteForceOverAllImages) {
    const auto& [name, H, grains] = GetParam();
    const std::vector<Vec2> x = scattered(H, grains, 1.5);  // outside the cell too
    std::vector<double> r;
    for (int g = 0; g < grains; ++g) r.push_back(0.003 + 0.004 * (g % 5) / 5);
    EXPECT_EQ(near_pairs(x, r, H, 0.001), all_images(x, r, H, 0.001, 16));
}

INSTANTIATE_TEST_SUITE_P(Cells, NearPairs,
                         testing::Values(Scene{"square", cell(0.1, 0, 0, 0.1), 60},
                                         Scene{"sheared_100_percent", cell(0.1, 0.1, 0, 0.1), 60},
                                         Scene{"sheared_730_percent", cell(0.1, 0.73, 0, 0.1), 60},
                                         Scene{"sheared_backwards", cell(0.1, 0, -0.33, 0.1), 60},
                                         Scene{"flat", cell(0.3, 0, 0, 0.02), 40},
                                         Scene{"tiny", cell(0.012, 0.003, 0, 0.011), 2},
                                         Scene{"rotated", cell(0.08, -0.06, 0.06, 0.08), 60}),
                         [](const auto& scene) { return scene.param.name; });

TEST(LatticeReduction, IsUnimodularAndShort) {
    const Mat2 H = cell(0.2, 3.17, 0.01, 0.2);
    const LatticeBasis out = reduce_lattice(H);
    EXPECT_EQ(out.change(0, 0) * out.change(1, 1) - out.change(0, 1) * out.change(1, 0), 1);
    EXPECT_LT((H * out.change.cast<double>() - out.basis).norm(), 1e-15);
    const double a = out.basis.col(0).squaredNorm(), b = out.basis.col(1).squaredNorm();
    EXPECT_LE(a, b);
    EXPECT_LE(std::abs(out.basis.col(0).dot(out.basis.col(1))), 0.5 * a * (1 + 1e-12));
}

TEST(ReduceLattice, EndsWhereTwoBasesAreEquallyShort) {
    const LatticeBasis found = reduce_lattice((Mat2() << 0.03, 5, 0, 0.01).finished());
    EXPECT_NEAR(found.basis.col(0).norm(), 0.01 * std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(std::fabs(found.basis.determinant()), 3e-4, 1e-12);
}

}  // namespace
}  // namespace sandgraph::dem
