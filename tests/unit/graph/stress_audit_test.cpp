#include "graph/screening/audit.hpp"

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
}

// Of one point little is known, and that is said: the interval reaches down to it from nearly everything.
TEST(AuditEstimate, OfOnePointIsWideAndANumber) {
    const AuditRow row = estimate(std::vector<double>{0.036}, 100);
    EXPECT_DOUBLE_EQ(row.mean, 0.036);
    EXPECT_GT(row.ci95, 0.8);
    EXPECT_LE(row.ci95, 1);
}

// Of 1,000 samples of 2 %, how many intervals contain the truth.
int contain(const std::vector<double>& population) {
    double truth = 0;
    for (const double e : population)
        truth += std::min(e, audit_cap) / static_cast<double>(population.size());
    int held = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        std::vector<double> sample;
        for (const std::int32_t p : draw_sample(population.size(), {0.02, seed, 0.01}))
            sample.push_back(population[static_cast<std::size_t>(p)]);
        const AuditRow row = estimate(sample, population.size());
        held += std::abs(row.mean - truth) <= row.ci95;
    }
    return held;
}

TEST(AuditEstimate, IntervalHoldsTheMeanNineteenTimesInTwentyAtLeast) {
    Random random(11);
    std::vector<double> even(2000), rare(2000);
    for (double& e : even) e = 0.02 * random.uniform() + 0.01 * random.uniform();
    for (double& e : rare) e = random.uniform() < 0.02 ? 3 * random.uniform() : 0.02 * random.uniform();
    EXPECT_GE(contain(even), 950);
    EXPECT_GE(contain(rare), 940);  // where most samples see one or none of the points that matter
}

TEST(AuditEstimate, IntervalNarrowsAsTheSampleGrows) {
    Random random(12);
    std::vector<double> errors(800);
    for (double& e : errors) e = 0.1 * random.uniform();
    const double few = estimate(std::span(errors).first(50), 100'000).ci95,
                 many = estimate(errors, 100'000).ci95;
    EXPECT_LT(many, 0.2 * few);
    EXPECT_GT(many, 0);
}

}  // namespace
}  // namespace sandgraph::graph
