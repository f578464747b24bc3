#include <gtest/gtest.h>

#include "surrogate/reference.hpp"
#include "surrogate/serving.hpp"
#include "tests/support/random_model.hpp"

namespace sandgraph::surrogate {
namespace {

// Below 1 kPa the spread is a share of 1 kPa, in the kernel as in its reference.
TEST(Spread, IsAShareOfAKilopascalAtLeast) {
    const Model model = support::random_model(5);
    const Reference reference(model);
    const Serving serving(model);
    stress::PackingTraits traits = support::dense_traits();
    traits.pressure = 400;
    const std::vector<std::int32_t> point{0};
    const std::vector<Mat2> F{(Mat2() << 1 + 1e-5, 2e-6, 0, 1 - 1e-5).finished()};
    std::vector<double> spreads;
    for (const stress::Surrogate* law : {static_cast<const stress::Surrogate*>(&reference),
                                         static_cast<const stress::Surrogate*>(&serving)}) {
        std::vector<double> state(law->state_size());
        law->start(traits, {-350, -450, 20}, state);
        std::vector<stress::SurrogateAnswer> answers(1);
        for (int k = 0; k < 3; ++k) law->update(point, F, state, answers);
        ASSERT_LT(mean_stress(answers[0].stress), 1000);
        spreads.push_back(answers[0].spread);
    }
    EXPECT_GT(spreads[0], 1e-6);
    EXPECT_NEAR(spreads[1], spreads[0], 1e-9 * spreads[0]);
}

}  // namespace
}  // namespace sandgraph::surrogate
