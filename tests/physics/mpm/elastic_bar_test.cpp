#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/bare_spec.hpp"

namespace sandgraph {
namespace {

// Bar fixed at x = 0, free at L. v(x, 0) = v0 sin(k x) with k = pi / (2 L) is mode 1 of u_tt = c^2 u_xx, so
// v_cm(t) = (1/L) int v dx = v0 (2/pi) cos(omega t), omega = k c.
constexpr double L = 25, young = 100, density = 1, v0 = 0.1;
constexpr int cells = 50;

simulation::Spec bar() {
    const double cell = L / cells;
    simulation::Spec spec = support::bare_spec({0, 0, cell, cells + 2, 1});
    spec.ground.extent = {0, 0, L, cell};
    spec.ground.density = density;
    spec.ground.velocity = [](double x, double) {
        return Vec2(v0 * std::sin(0.5 * std::numbers::pi * x / L), 0);
    };
    spec.law = support::elastic({young, 0});
    spec.boundaries = {mpm::Side::fixed, mpm::Side::free, mpm::Side::mirror, mpm::Side::mirror};
    spec.scheme.courant = 0.1;
    return spec;
}

TEST(ElasticBar, SwingsInItsFirstModeForThreePeriods) {
    simulation::Simulation model(bar());
    const double omega = 0.5 * std::numbers::pi / L * std::sqrt(young / density),
                 mass = density * L * L / cells;
    double worst = 0;
    while (model.time() < 30) {
        model.step();
        const double v = mpm::momentum(model.state().points).x() / mass;
        worst = std::max(worst, std::fabs(v - v0 * 2 / std::numbers::pi * std::cos(omega * model.time())));
    }
    EXPECT_LT(worst, 0.01 * v0);
    RecordProperty("worst_over_v0", std::to_string(worst / v0));
}

TEST(ElasticBar, KeepsItsEnergy) {
    simulation::Simulation model(bar());
    const double before = mpm::kinetic_energy(model.state().points);
    double low = 1, high = 1;
    for (int k = 0; k < 6000; ++k) {
        model.step();
        const double total = (mpm::kinetic_energy(model.state().points) + model.state().stress_work) / before;
        low = std::min(low, total), high = std::max(high, total);
    }
    EXPECT_GT(low, 0.995);
    EXPECT_LT(high, 1.002);
    RecordProperty("energy_low_high", std::to_string(low) + " " + std::to_string(high));
}

}  // namespace
}  // namespace sandgraph
