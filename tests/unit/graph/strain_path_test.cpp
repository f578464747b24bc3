#include "graph/strain_path.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "base/random.hpp"
#include "dem/rve.hpp"
#include "tests/support/public_packing.hpp"
#include "tests/support/table1_options.hpp"

namespace sandgraph::graph {
namespace {

// A wandering path with spin, small dither and reversals, as a material point sees it.
std::vector<Mat2> wandering(std::uint64_t seed, int steps, double size) {
    Random random(seed);
    std::vector<Mat2> path;
    Mat2 F = Mat2::Identity(), drift = Mat2::Zero();
    for (int k = 0; k < steps; ++k) {
        if (k % 40 == 0)
            drift << random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                random.uniform(-1, 1);
        Mat2 dither;
        dither << random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1);
        F = (Mat2::Identity() + size * (drift + 0.2 * dither)) * F;
        path.push_back(F);
    }
    return path;
}

double distance_to_segment(const Mat2& F, const Mat2& a, const Mat2& b) {
    const Mat2 ab = b - a;
    const double length2 = ab.squaredNorm();
    const double t = length2 > 0 ? ((F - a).array() * ab.array()).sum() / length2 : 0;
    return (F - a - std::clamp(t, 0.0, 1.0) * ab).norm();
}

std::vector<Mat2> corners(StrainPath path) {
    std::vector<Mat2> out{path.driven()};
    while (!path.done()) {
        path.advance(1e9);
        out.push_back(path.driven());
    }
    return out;
}

TEST(StrainPath, EveryPointLiesWithinTheErrorInOrder) {
    StrainPath path(2e-5);
    const auto all = wandering(3, 600, 5e-6);
    for (const Mat2& F : all) path.add(F);
    const auto knots = corners(path);
    ASSERT_GT(knots.size(), 3u);
    EXPECT_LT(knots.size(), all.size() / 8);
    std::size_t segment = 0;
    for (const Mat2& F : all) {
        while (segment + 2 < knots.size() &&
               distance_to_segment(F, knots[segment], knots[segment + 1]) > path.error())
            ++segment;
        EXPECT_LE(distance_to_segment(F, knots[segment], knots[segment + 1]), path.error());
    }
    EXPECT_EQ(knots.back(), all.back());
}

TEST(StrainPath, KeepsReversals) {
    StrainPath path(1e-5);
    const auto at = [](double shear) { return (Mat2() << 1, shear, 0, 1).finished(); };
    for (int k = 0; k <= 100; ++k) path.add(at(1e-5 * k));
    for (int k = 100; k >= 20; --k) path.add(at(1e-5 * k));
    double furthest = 0;
    for (const Mat2& F : corners(path)) furthest = std::max(furthest, F(0, 1));
    EXPECT_NEAR(furthest, 1e-3, 1e-5);
}

std::vector<std::uint8_t> bytes_of(const StrainPath& path) {
    std::vector<std::uint8_t> bytes;
    ByteWriter out(bytes);
    path.save(out);
    return bytes;
}

// Points are added to both all the while; now and then one is driven and the other told how far.
TEST(StrainPath, FollowsACopyThatIsDrivenElsewhere) {
    StrainPath driven(2e-5), told(2e-5);
    Random random(11);
    int ends = 0;
    for (const Mat2& F : wandering(7, 1500, 5e-6)) {
        driven.add(F), told.add(F);
        if (random.uniform() > 0.2) continue;
        for (int piece = 0; piece < 4 && !driven.done(); ++piece) driven.advance(random.uniform(1e-6, 2e-4));
        told.follow(driven.place());
        ASSERT_EQ(bytes_of(driven), bytes_of(told));
        ends += driven.done();
    }
    EXPECT_GT(ends, 10);
}

TEST(StrainPath, HoldsABoundedNumberOfKnots) {
    StrainPath path(1e-7);
    for (const Mat2& F : wandering(5, 4000, 1e-5)) {
        path.add(F);
        ASSERT_LE(path.knots(), StrainPath::knots_max);
    }
    EXPECT_GT(path.error(), 2e-7);  // which it pays for with a wider tolerance
}

TEST(StrainPath, PiecesMultiplyUpToTheWholeDeformation) {
    StrainPath path(1e-5);
    Mat2 F = Mat2::Identity();
    for (const Mat2& next : wandering(7, 300, 2e-5)) {
        path.add(next);
        const Mat2 piece = path.advance(1e-5);
        EXPECT_LE(strain_norm(piece), 1.001e-5);
        F = piece * F;
    }
    while (!path.done()) F = path.advance(3e-5) * F;
    EXPECT_LT((F - path.latest()).norm(), 1e-12);
    EXPECT_EQ(path.advance(1), Mat2(Mat2::Identity()));
}

// What the path is for. 0.02 of p is the default of gate.path_error.
TEST(StrainPath, APackingDrivenAlongItStandsWhereItsTwinStands) {
    const auto traits = support::public_traits();
    const double tolerance = 0.02 * traits.pressure / (2 * traits.shear);
    dem::Workspace work;
    double worst = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        dem::Rve twin(support::public_packing().packing), replayed(support::public_packing().packing);
        StrainPath path(tolerance);
        Mat2 before = Mat2::Identity();
        for (const Mat2& F : wandering(seed, 600, 5e-6)) {
            twin.update(F * before.inverse(), {}, support::table1_options(), work);
            before = F;
            path.add(F);
        }
        while (!path.done()) replayed.update(path.advance(1e-3), {}, support::table1_options(), work);
        const double p = 0.5 * twin.stress().trace();
        worst = std::max(worst, (twin.stress() - replayed.stress()).norm() / p);
    }
    RecordProperty("worst_share_of_p", std::to_string(worst));
    EXPECT_LT(worst, 0.05);
}

}  // namespace
}  // namespace sandgraph::graph
