#include "stress/increment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sandgraph::stress {
namespace {

Mat2 rotation(double angle) {
    return (Mat2() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
}

TEST(Increment, ARotationStrainsNothing) {
    for (const double angle : {1e-6, 0.1, 1.0, 3.0}) {
        const Increment e = increment(rotation(angle));
        EXPECT_NEAR(std::hypot(e.xx, e.yy, e.xy), 0, 1e-15);
        EXPECT_NEAR(e.cos, std::cos(angle), 1e-15);
        EXPECT_NEAR(e.sin, std::sin(angle), 1e-15);
    }
}

TEST(Increment, IsTheLogarithmOfTheStretchToThirdOrder) {
    for (const double stretch : {0.02, 0.01}) {
        const Mat2 turn = rotation(0.4),
                   U = turn.transpose() * Vec2(1 + stretch, 1 - 0.5 * stretch).asDiagonal() * turn;
        const Increment e = increment(rotation(0.7) * U);
        const Mat2 log =
            turn.transpose() * Vec2(std::log1p(stretch), std::log1p(-0.5 * stretch)).asDiagonal() * turn;
        EXPECT_NEAR(e.xx, log(0, 0), 0.1 * std::pow(stretch, 3));
        EXPECT_NEAR(e.yy, log(1, 1), 0.1 * std::pow(stretch, 3));
        EXPECT_NEAR(e.xy, log(0, 1), 0.1 * std::pow(stretch, 3));
    }
}

TEST(Rotate, TurnsAStressAsATensor) {
    const Stress s{3, -1, 2}, turned = rotate(s, std::cos(0.6), std::sin(0.6));
    const Mat2 exact = rotation(0.6) * (Mat2() << 3, 2, 2, -1).finished() * rotation(0.6).transpose();
    EXPECT_NEAR(turned.xx, exact(0, 0), 1e-14);
    EXPECT_NEAR(turned.yy, exact(1, 1), 1e-14);
    EXPECT_NEAR(turned.xy, exact(0, 1), 1e-14);
}

}  // namespace
}  // namespace sandgraph::stress
