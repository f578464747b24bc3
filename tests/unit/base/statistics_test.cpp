#include "base/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sandgraph {
namespace {

TEST(Statistics, MeanAndDeviationAreThoseOfTheTextbook) {
    const Sample s = sample_of(std::vector{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
    EXPECT_EQ(s.count, 8u);
    EXPECT_DOUBLE_EQ(s.mean, 5);
    EXPECT_DOUBLE_EQ(s.deviation, std::sqrt(32. / 7));
    EXPECT_NEAR(s.ci95, 2.365 * s.deviation / std::sqrt(8.), 1e-12);  // Student, 7 degrees of freedom
}

TEST(Statistics, OneValueHasNoIntervalAndNoneHasNoMean) {
    const Sample one = sample_of(std::vector{3.0});
    EXPECT_EQ(one.mean, 3);
    EXPECT_TRUE(std::isnan(one.ci95));
    EXPECT_TRUE(std::isnan(one.deviation));
    EXPECT_TRUE(std::isnan(sample_of({}).mean));
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Statistics, QuantilesLieBetweenTheValuesInOrder) {
    const std::vector<double> values{5, 1, 3, 2, 4};
    EXPECT_DOUBLE_EQ(quantile(values, 0), 1);
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 3);
    EXPECT_DOUBLE_EQ(quantile(values, 0.05), 1.2);
    EXPECT_DOUBLE_EQ(quantile(values, 1), 5);
}

}  // namespace
}  // namespace sandgraph
