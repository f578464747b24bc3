#include "base/tensor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace sandgraph {
namespace {

TEST(Tensor, SignChangesOnceAndBack) {
    const Stress s{-3e3, -1e3, 500};
    EXPECT_EQ(tension_positive(compression_positive(s)), s);
    EXPECT_EQ(compression_positive(s)(0, 0), 3e3);
}

TEST(Tensor, KeepsTheSymmetricPartOnly) {
    EXPECT_EQ(tension_positive((Mat2() << 1, 4, 2, 5).finished()), (Stress{-1, -5, -3}));
}

TEST(Tensor, InvariantsDoNotSeeRotation) {
    const Stress s{-3e3, -1e3, 500};
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(0.7).toRotationMatrix();
    const Stress turned = tension_positive(R * compression_positive(s) * R.transpose());
    EXPECT_NEAR(mean_stress(turned), mean_stress(s), 1e-9);
    EXPECT_NEAR(deviator(turned), deviator(s), 1e-9);
    EXPECT_GT(mean_stress(s), 0);
}

}  // namespace
}  // namespace sandgraph
