#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mpm/layout.hpp"
#include "stress/elastic.hpp"
#include "tests/support/macro_model.hpp"

namespace sandgraph {
namespace {

// Bar fixed at x = 0, free at L. v(x, 0) = v0 sin(k x) with k = pi / (2 L) is mode 1 of u_tt = c^2 u_xx, so
// v_cm(t) = (1/L) int v dx = v0 (2/pi) cos(omega t), omega = k c.
constexpr double L = 25, young = 100, density = 1, v0 = 0.1;
constexpr int cells = 50;

support::MacroModel bar() {
    const double cell = L / cells;
    support::MacroModel model({0, 0, cell, cells + 2, 1});
    model.points = mpm::lay_out({{0, 0, L, cell}, cell, 1, density, {}});
    for (std::size_t p = 0; p < model.points.size(); ++p)
        model.points.vx[p] = v0 * std::sin(0.5 * std::numbers::pi * model.points.x[p] / L);
    model.law = std::make_unique<stress::Elastic>(stress::ElasticConstants{young, 0},
                                                  std::vector<Stress>(model.points.size()));
    model.update.boundaries = {mpm::Side::fixed, mpm::Side::free, mpm::Side::mirror, mpm::Side::mirror};
    model.set_time_step(0.1 * cell / std::sqrt(young / density));
    model.audit = true;
    model.start();
    return model;
}

TEST(ElasticBar, SwingsInItsFirstModeForThreePeriods) {
    support::MacroModel model = bar();
    const double omega = 0.5 * std::numbers::pi / L * std::sqrt(young / density),
                 mass = density * L * L / cells;
    double worst = 0;
    for (double t = 0; t < 30;) {
        model.step();
        t += model.update.dt;
        const double v = mpm::momentum(model.points).x() / mass;
        worst = std::max(worst, std::fabs(v - v0 * 2 / std::numbers::pi * std::cos(omega * t)));
    }
    EXPECT_LT(worst, 0.01 * v0);
    RecordProperty("worst_over_v0", std::to_string(worst / v0));
}

TEST(ElasticBar, KeepsItsEnergy) {
    support::MacroModel model = bar();
    const double before = mpm::kinetic_energy(model.points);
    double low = 1, high = 1;
    for (int k = 0; k < 6000; ++k) {
        model.step();
        const double total = (mpm::kinetic_energy(model.points) + model.work) / before;
        low = std::min(low, total), high = std::max(high, total);
    }
    EXPECT_GT(low, 0.995);
    EXPECT_LT(high, 1.002);
    RecordProperty("energy_low_high", std::to_string(low) + " " + std::to_string(high));
}

}  // namespace
}  // namespace sandgraph
