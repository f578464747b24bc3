#include "surrogate/kernel.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <limits>

#include "surrogate/serving.hpp"
#include "tests/unit/surrogate/driver.hpp"

namespace sandgraph::surrogate {
namespace {

// Points of a law, all started alike, driven along paths of their own.
struct Crowd {
    Crowd(const stress::Surrogate& l, std::size_t count)
        : law(l), states(count * law.state_size()), answers(count), ids(count) {
        for (std::size_t i = 0; i < count; ++i) {
            ids[i] = static_cast<std::int32_t>(i);
            law.start(support::dense_traits(), support::rest_stress(), state(i));
            paths.push_back(random_path(100 + i, 20, 1e-5 * std::pow(1.3, i % 12)));
        }
    }
    std::span<double> state(std::size_t i) {
        return std::span(states).subspan(i * law.state_size(), law.state_size());
    }
    // Increment `step` of the points in `batch`, in that order.
    void drive(std::size_t step, std::span<const std::int32_t> batch) {
        std::vector<Mat2> F;
        for (const auto& path : paths) F.push_back(path[step]);
        std::vector<stress::SurrogateAnswer> slots(batch.size());
        law.update(batch, F, states, slots);
        for (std::size_t k = 0; k < batch.size(); ++k) answers[static_cast<std::size_t>(batch[k])] = slots[k];
    }

    const stress::Surrogate& law;
    std::vector<double> states;
    std::vector<stress::SurrogateAnswer> answers;
    std::vector<std::int32_t> ids;
    std::vector<std::vector<Mat2>> paths;
};

void expect_agreement(const Model& model) {
    const Reference reference(model);
    const Serving serving(model);
    Crowd a(reference, 19), b(serving, 19);
    for (std::size_t step = 0; step < 20; ++step) {
        b.states = a.states;
        a.drive(step, a.ids);
        b.drive(step, b.ids);
        for (std::size_t i = 0; i < 19; ++i) {
            EXPECT_LT(difference(b.answers[i].stress, a.answers[i].stress), 1e-12) << step << " " << i;
            EXPECT_NEAR(b.answers[i].spread, a.answers[i].spread, 1e-12);
            EXPECT_NEAR(b.answers[i].distance, a.answers[i].distance, 1e-12);
            for (std::size_t c = 0; c < reference.state_size(); ++c)
                EXPECT_NEAR(b.state(i)[c], a.state(i)[c],
                            1e-12 * std::max(1.0, std::abs(a.state(i)[c]) + 2e4))
                    << c;
        }
    }
}

// Every instruction set of this machine in turn.
class Kernel : public testing::TestWithParam<std::int64_t> {
  protected:
    void SetUp() override { choose(GetParam()); }
    void TearDown() override { choose(0); }
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

TEST_P(Kernel, AgreesWithTheScalarForm) {
    ASSERT_EQ(kernel_target(), hwy::TargetName(GetParam()));
    expect_agreement(support::random_model(1));
    expect_agreement(support::random_model(2, {1, 3, 5, 2}));
    expect_agreement(support::random_model(3, {5, 8, 0, 0}));
    Model elastic = support::random_model(4, {2, 4, 0, 0});
    elastic.frictional = false;
    expect_agreement(elastic);
}

TEST_P(Kernel, BitsDoNotDependOnTheBatch) {
    const Serving law(support::random_model(1));
    Crowd whole(law, 23), split(law, 23);
    for (std::size_t step = 0; step < 20; ++step) {
        whole.drive(step, whole.ids);
        std::vector<std::int32_t> order(split.ids.rbegin(), split.ids.rend());
        std::rotate(order.begin(), order.begin() + static_cast<long>(step), order.end());
        for (std::size_t first = 0, size = 1; first < order.size(); first += size, size += 2)
            split.drive(step, std::span(order).subspan(first, std::min(size, order.size() - first)));
    }
    EXPECT_EQ(whole.states, split.states);
    for (std::size_t i = 0; i < 23; ++i) {
        EXPECT_EQ(whole.answers[i].stress, split.answers[i].stress);
        EXPECT_EQ(whole.answers[i].spread, split.answers[i].spread);
        EXPECT_EQ(whole.answers[i].distance, split.answers[i].distance);
    }
}

TEST_P(Kernel, IncrementThatIsNoNumberShowsInTheDistance) {
    const Serving law(support::random_model(1));
    Driver point(law);
    EXPECT_TRUE(
        std::isnan(point.drive(gradient(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0)).distance));
}

std::string target_name(const testing::TestParamInfo<std::int64_t>& target) {
    return hwy::TargetName(target.param);
}
INSTANTIATE_TEST_SUITE_P(Targets, Kernel, testing::ValuesIn(kernel_targets()), target_name);

}  // namespace
}  // namespace sandgraph::surrogate
