#include "packings/sand_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "packings/compressed_packings.hpp"

namespace sandgraph::packings {
namespace {

TEST(SandFriction, IntervalIsStudentsOfTheMean) {
    const double angles[] = {0.50, 0.52, 0.54, 0.56, 0.58, 0.60};
    const FrictionSample s = friction_sample(angles);
    EXPECT_NEAR(s.mean, 0.55, 1e-12);
    EXPECT_EQ(s.packings, 6);
    // sd = 0.02 sqrt(3.5), t(5) = 2.571
    EXPECT_NEAR(s.ci95, 2.571 * 0.02 * std::sqrt(3.5) / std::sqrt(6), 1e-9);
}

TEST(SandFriction, OfOnePackingHasNoInterval) {
    const double angle[] = {0.5};
    EXPECT_EQ(friction_sample(angle).mean, 0.5);
    EXPECT_TRUE(std::isnan(friction_sample(angle).ci95));
    EXPECT_EQ(friction_sample(angle).packings, 1);
}

TEST(SandFriction, IsOfSeveralPackingsOfTheRecipe) {
    scene::Grains grains;
    grains.count = 30;
    grains.seed = 5;
    const double first[] = {CompressedPackings(grains).friction()};
    const FrictionSample s = sampled_friction(grains, first, {});
    EXPECT_EQ(s.packings, 6);
    EXPECT_GT(s.ci95, 0);
    double sum = 0;
    for (int k = 0; k < 6; ++k, ++grains.seed) sum += CompressedPackings(grains).friction();
    EXPECT_NEAR(s.mean, sum / 6, 1e-12);
}

}  // namespace
}  // namespace sandgraph::packings
