#include <gtest/gtest.h>

#include "tests/unit/surrogate/driver.hpp"

namespace sandgraph::surrogate {
namespace {

const Mat2 still = Mat2::Identity();

TEST(ElementNetwork, StartsAtTheInSituStress) {
    const Reference law(support::random_model(1));
    for (const Stress initial : {Stress{-2e4, -2e4, 0}, support::rest_stress(), Stress{-3e4, -1e4, 2e3}})
        EXPECT_LT(difference(Driver(law, initial).drive(still).stress, initial), 1e-15);
}

// K0 stress above the model's strength: the point keeps its stress, its friction limits are raised to it.
TEST(ElementNetwork, StartsAboveItsStrengthWithoutAJump) {
    const Reference law(support::random_model(1));
    const Stress steep{-40e3, -3e3, 0};  // q/p = 0.86
    Driver point(law, steep);
    EXPECT_LT(difference(point.drive(still).stress, steep), 1e-15);
    EXPECT_LT(difference(point.drive(gradient(-1e-8, 0, 0, 0)).stress, steep), 1e-3);
}

TEST(ElementNetwork, AnswerTurnsWithTheFrameOfThePath) {
    const Reference law(support::random_model(2));
    const Mat2 Q = rotation(0.7);
    const auto turned = [&](const Stress& s) {
        const Mat2 t = Q * tensor(s) * Q.transpose();
        return Stress{t(0, 0), t(1, 1), t(0, 1)};
    };
    stress::PackingTraits traits = support::dense_traits();
    const Mat2 fabric =
        (Mat2() << traits.fabric_xx, traits.fabric_xy, traits.fabric_xy, -traits.fabric_xx).finished();
    Driver a(law, support::rest_stress(), traits);
    const Mat2 turned_fabric = Q * fabric * Q.transpose();
    traits.fabric_xx = turned_fabric(0, 0);
    traits.fabric_xy = turned_fabric(0, 1);
    Driver b(law, turned(support::rest_stress()), traits);
    double limit = 0;  // per update; F rounded in another frame is another F, by 1e-16 of 1e-4
    for (const Mat2& F : random_path(3))
        EXPECT_LT(difference(b.drive(Q * F * Q.transpose()).stress, turned(a.drive(F).stress)),
                  limit += 1e-12);
}

TEST(ElementNetwork, SuperposedRotationTurnsTheStressAlong) {
    const Reference law(support::random_model(2));
    Driver a(law), b(law);
    Mat2 Q = still;
    double angle = 0, limit = 0;
    for (const Mat2& F : random_path(4)) {
        const Mat2 next = rotation(angle += 0.03);
        const Mat2 expected = next * tensor(a.drive(F).stress) * next.transpose();
        const Stress found = b.drive(next * F * Q.transpose()).stress;
        EXPECT_LT((tensor(found) - expected).norm() / mean_stress(found), limit += 1e-12);
        Q = next;
    }
}

TEST(ElementNetwork, MirroredPathGivesTheMirroredStress) {
    const Reference law(support::random_model(5));
    const Mat2 mirror = (Mat2() << -1, 0, 0, 1).finished();
    stress::PackingTraits traits = support::dense_traits();
    Driver a(law, support::rest_stress(), traits);
    traits.fabric_xy *= -1;
    Stress start = support::rest_stress();
    start.xy *= -1;
    Driver b(law, start, traits);
    double limit = 0;
    for (const Mat2& F : random_path(6)) {
        Stress s = a.drive(F).stress;
        s.xy *= -1;
        EXPECT_LT(difference(b.drive(mirror * F * mirror).stress, s), limit += 1e-12);
    }
}

// The same stretch to about (xx, yy, xy) in `steps` increments, each given whole or in ten parts.
Stress proportional(const Reference& law, const std::array<double, 3>& strain, int steps, bool in_parts) {
    Driver point(law);
    Stress s;
    const double n = 10.0 * steps;
    const Mat2 part = gradient(strain[0] / n, strain[1] / n, strain[2] / n, strain[2] / n);
    Mat2 whole = still;
    for (int i = 0; i < 10; ++i) whole = part * whole;
    for (int i = 0; i < steps * 10; ++i)
        if (in_parts || i % 10 == 9) s = point.drive(in_parts ? part : whole).stress;
    return s;
}

TEST(ElementNetwork, TenTimesFinerIncrementsChangeLittle) {
    double worst = 0;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        const Reference law(support::random_model(seed));
        for (const std::array<double, 3> strain : {std::array{-5e-3, 5e-3, 0.0}, std::array{-4e-3, 2e-3, 0.0},
                                                   std::array{0.0, -5e-3, 0.0}, std::array{1e-3, 0.0, 5e-3}})
            for (const int steps : {1, 7, 50, 200})
                worst = std::max(worst, difference(proportional(law, strain, steps, false),
                                                   proportional(law, strain, steps, true)));
    }
    EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace sandgraph::surrogate
