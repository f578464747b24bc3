#include <gtest/gtest.h>

#include "stress/increment.hpp"
#include "tests/unit/surrogate/driver.hpp"

namespace sandgraph::surrogate {
namespace {

// One member, whose critical state is then that of the ensemble.
Model model_of(std::uint64_t seed) {
    Model model = support::random_model(seed, {1, 8, 16, 3});
    model.members[0].critical = {0.05, 1, 0.25, 0.02};
    return model;
}

// Void ratio after simple shear to 400 % during which p is held as a laboratory would.
double void_ratio_after_shear(const Reference& law, double porosity) {
    constexpr double step = 2e-3;
    stress::PackingTraits traits = support::dense_traits();
    traits.porosity = porosity;
    const double p0 = traits.pressure;
    Driver point(law, {-p0, -p0, 0}, traits);
    double J = 1, p = p0, rate = 0;
    for (int i = 0; i < 2000; ++i) {
        const double off = (p - p0) / traits.bulk;
        rate += 0.05 * off;
        const double dilation = std::clamp(0.3 * off + rate, -step, step);
        const Mat2 F = gradient(0.5 * dilation, 0.5 * dilation, step, 0);
        J *= F(0, 0) * F(1, 1);
        p = mean_stress(point.drive(F).stress);
    }
    EXPECT_NEAR(p, p0, 0.05 * p0);
    return J / (1 - porosity) - 1;
}

class CriticalStateOf : public testing::TestWithParam<std::uint64_t> {};

// Whatever the network says, grains forget how dense they began.
TEST_P(CriticalStateOf, AnyNetworkIsReachedFromDenseAndFromLoose) {
    const Model model = model_of(GetParam());
    const Reference law(model);
    const CriticalState& c = model.members[0].critical;
    const double expected = c.void_ratio - c.slope * 0.2;  // at 20 kPa
    EXPECT_NEAR(void_ratio_after_shear(law, 0.16), expected, 0.004);
    EXPECT_NEAR(void_ratio_after_shear(law, 0.22), expected, 0.004);
}

INSTANTIATE_TEST_SUITE_P(Networks, CriticalStateOf, testing::Values(1, 2, 3));

}  // namespace
}  // namespace sandgraph::surrogate
