#include "report/biaxial_picture.hpp"

#include <gtest/gtest.h>

#include "tests/unit/io/scratch.hpp"

namespace sandgraph::report {
namespace {

std::vector<dem::BiaxialRow> straight(double slope, std::size_t rows) {
    std::vector<dem::BiaxialRow> test(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        test[k].axial_strain = 0.01 * static_cast<double>(k);
        test[k].sin_phi = slope * test[k].axial_strain;
        test[k].volumetric_strain = -0.1 * test[k].sin_phi;
    }
    return test;
}

TEST(BiaxialPicture, MeanGoesAsFarAsTheShortestTestWithDilationUp) {
    const auto mean = mean_test({64e3, {straight(1, 11), straight(3, 9)}});
    ASSERT_EQ(mean.size(), 9u);
    EXPECT_NEAR(mean.back().sin_phi, 2 * 0.08, 1e-15);
    EXPECT_NEAR(mean.back().dilation, 0.1 * 2 * 0.08, 1e-15);
    EXPECT_TRUE(mean_test({64e3, {}}).empty());
}

TEST(BiaxialPicture, IsDrawn) {
    const test::Scratch scratch;
    const auto png = scratch / "biaxial.png";
    const Picture picture = draw_biaxial_picture(
        {"it's dense", {{32e3, {straight(1, 11), straight(2, 11)}}, {64e3, {straight(1.5, 11)}}}}, png);
    ASSERT_TRUE(picture.drawn) << picture.message;
    EXPECT_EQ(picture.message, "");
    EXPECT_EQ(test::contents(png).substr(1, 3), "PNG");
}

}  // namespace
}  // namespace sandgraph::report
