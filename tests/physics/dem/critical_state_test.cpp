#include <algorithm>
#include <cmath>

#include "dem/packing/observe.hpp"
#include "dem/rve.hpp"
#include "dem/stretch.hpp"
#include "public_packing.hpp"
#include "tests/support/table1_options.hpp"

namespace sandgraph::dem {
namespace {

constexpr double kPressure = 32e3, kModulus = 2e7;  // [Pa]
constexpr double kIncrement = 2e-4, kStrain = 5;    // of gamma

struct State {
    double stress_ratio = 0, porosity = 0, anisotropy = 0;  // q/p, n, F_a
    State& operator+=(const State& s) {
        stress_ratio += s.stress_ratio, porosity += s.porosity, anisotropy += s.anisotropy;
        return *this;
    }
    State operator/(double n) const { return {stress_ratio / n, porosity / n, anisotropy / n}; }
};

State state_of(const Rve& rve) {
    const Mat2 s = rve.stress();
    const Packing p = to_packing(rve.packing());
    const double q = std::hypot(0.5 * (s(0, 0) - s(1, 1)), 0.5 * (s(0, 1) + s(1, 0)));
    return {2 * q / s.trace(), rve.porosity(), observe(p, contact_forces(p, {}), {}).anisotropy};
}

// Shear at constant mean stress: the area follows the missing pressure.
Mat2 shear_increment(const Rve& rve, double direction) {
    const double missing = kPressure - 0.5 * rve.stress().trace();
    const double area = std::clamp(-0.3 * missing / kModulus, -kIncrement, kIncrement);
    return turned(test::matrix(1 + area, kIncrement, 0, 1 + area), direction);
}

// Mean over the late half of a simple shear whose shear plane lies at `direction` [rad].
State sheared(const std::string& density, double direction) {
    const Packing p = test::resting(density, {}, 4000);
    FastAssembly start(p, {});
    Rve rve(compact(p, {}, start.stress()));
    Workspace work;
    RveOptions options = support::table1_options();
    options.inertial_number_max = 1e-2, options.strain_per_step_max = 1e-4;
    State sum;
    int samples = 0;
    const int increments = static_cast<int>(kStrain / kIncrement);
    for (int k = 0; k < increments; ++k) {
        EXPECT_EQ(rve.update(shear_increment(rve, direction), {}, options, work).status, RveStatus::ok);
        if (2 * k < increments || k % 50 != 0) continue;
        sum += state_of(rve), ++samples;
    }
    return sum / samples;
}

// Three directions stand for three packings.
State critical_state(const std::string& density) {
    State sum;
    for (const double direction : {0.0, 1.0, 2.0}) sum += sheared(density, direction);
    return sum / 3;
}

std::string text(const State& s) {
    return std::to_string(s.stress_ratio) + " " + std::to_string(s.porosity) + " " +
           std::to_string(s.anisotropy);
}

TEST(CriticalState, DenseAndLooseSandForgetWhereTheyCameFrom) {
    const State dense = critical_state("dense"), loose = critical_state("loose");
    RecordProperty("dense", text(dense)), RecordProperty("loose", text(loose));
    EXPECT_NEAR(dense.stress_ratio, loose.stress_ratio, 0.03);
    EXPECT_NEAR(dense.porosity, loose.porosity, 0.005);  // they began 0.04 apart
    EXPECT_NEAR(dense.anisotropy, loose.anisotropy, 0.04);
    for (const State& s : {dense, loose}) {  // Liang et al. (2021), and the scatter of 400 grains about it
        EXPECT_NEAR(s.stress_ratio, 0.36, 0.035);
        EXPECT_NEAR(s.porosity, 0.206, 0.006);
        EXPECT_NEAR(s.anisotropy, 0.32, 0.04);
    }
}

}  // namespace
}  // namespace sandgraph::dem
