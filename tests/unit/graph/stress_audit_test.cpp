#include "graph/stress_audit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "base/random.hpp"

namespace sandgraph::graph {
namespace {

TEST(AuditSample, HasItsShareAndNoPointTwice) {
    const auto ids = draw_sample(7995, {0.01, 1, 0.01});
    EXPECT_EQ(ids.size(), 80u);
    EXPECT_EQ(std::set<std::int32_t>(ids.begin(), ids.end()).size(), 80u);
    EXPECT_EQ(draw_sample(50, {1, 1, 0.01}).size(), 50u);
    EXPECT_TRUE(draw_sample(50, {0, 1, 0.01}).empty());
    EXPECT_NE(ids, draw_sample(7995, {0.01, 2, 0.01}));
}

TEST(AuditSample, DrawsEveryPointAsOften) {
    std::vector<int> drawn(20, 0);
    for (std::uint64_t seed = 0; seed < 4000; ++seed)
        for (const std::int32_t p : draw_sample(20, {0.25, seed, 0.01})) ++drawn[static_cast<std::size_t>(p)];
    for (const int count : drawn) EXPECT_NEAR(count, 1000, 140);  // five standard deviations
}

TEST(AuditEstimate, OfACensusIsExact) {
    const std::vector<double> all{0.01, 0.02, 0.06};
    const AuditRow row = estimate(all, 3);
    EXPECT_DOUBLE_EQ(row.mean, 0.03);
    EXPECT_EQ(row.ci95, 0);
    EXPECT_TRUE(std::isnan(estimate({}, 100).mean));
    EXPECT_TRUE(std::isnan(estimate(std::vector<double>{1}, 100).ci95));
}

TEST(AuditEstimate, IntervalHoldsTheMeanAboutNineteenTimesInTwenty) {
    Random random(11);
    std::vector<double> population(2000);
    for (double& e : population) e = 0.02 * random.uniform() + 0.01 * random.uniform();
    const double truth = std::accumulate(population.begin(), population.end(), 0.0) / 2000;
    int held = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        std::vector<double> sample;
        for (const std::int32_t p : draw_sample(2000, {0.02, seed, 0.01}))
            sample.push_back(population[static_cast<std::size_t>(p)]);
        const AuditRow row = estimate(sample, 2000);
        held += std::abs(row.mean - truth) <= row.ci95;
    }
    EXPECT_NEAR(held, 1900, 50);
}

TEST(Student, QuantilesAgreeWithTheTables) {
    EXPECT_NEAR(student_975(1), 12.706, 1e-3);
    EXPECT_NEAR(student_975(2), 4.303, 1e-3);
    EXPECT_NEAR(student_975(4), 2.776, 0.01);
    EXPECT_NEAR(student_975(9), 2.262, 1e-3);
    EXPECT_NEAR(student_975(78), 1.991, 1e-3);
}

}  // namespace
}  // namespace sandgraph::graph
