#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/bare_spec.hpp"

namespace sandgraph {
namespace {

// Sulsky's disks: r 0.2 m, E 1000 Pa, nu 0.3, rho 1000 kg/m3, centres (0.3, 0.3) and (0.7, 0.7) m,
// towards each other at (0.1, 0.1) m/s: they meet at (0.4 sqrt 2 - 2 r) / (0.2 sqrt 2) = 0.586 s.
constexpr double cell = 0.05, r = 0.2, density = 1000, speed = 0.1;

simulation::Spec disks(double hourglass) {
    simulation::Spec spec = support::bare_spec({-0.5, -0.5, cell, 40, 40});
    spec.ground.points_per_cell = 4;
    spec.ground.density = density;
    spec.ground.inside = [](double x, double y) {
        return std::hypot(x - 0.3, y - 0.3) < r || std::hypot(x - 0.7, y - 0.7) < r;
    };
    spec.ground.velocity = [](double x, double) { return Vec2::Constant(x < 0.5 ? speed : -speed); };
    spec.law = support::elastic({1000, 0.3});
    spec.scheme.courant = 0.1;
    spec.scheme.hourglass = hourglass;
    return spec;
}

struct Collision {
    double minimum = 1, minimum_time = 0, final_kinetic = 0, final_total = 0, largest_total = 0, momentum = 0;
};

Collision collide(double hourglass) {
    simulation::Simulation model(disks(hourglass));
    const mpm::Points& points = model.state().points;
    Collision c;
    const double before = mpm::kinetic_energy(points);
    while (model.time() < 3.5) {
        const double t = model.time();
        model.step();
        const double share = mpm::kinetic_energy(points) / before;
        if (share < c.minimum) c.minimum = share, c.minimum_time = t;
        c.momentum = std::max(c.momentum, mpm::momentum(points).norm());
        c.final_kinetic = share, c.final_total = share + model.state().stress_work / before;
        c.largest_total = std::max(c.largest_total, c.final_total);
    }
    return c;
}

TEST(CollidingDisks, KeepZeroMomentumAndGiveTheirEnergyBack) {
    const Collision c = collide(1);
    EXPECT_LT(c.momentum, 1e-11);           // of 12.6 kg/m * 0.14 m/s each
    EXPECT_NEAR(c.minimum, 0.0287, 0.003);  // 0.0286 on cells half as large
    EXPECT_NEAR(c.minimum_time, 0.92, 0.06);
    EXPECT_GT(c.final_kinetic, 0.87);
    EXPECT_LT(c.largest_total, 1 + 1e-3);  // no step makes energy
    EXPECT_GT(c.final_total, 0.918);       // what crossing cells takes; the rest is kinetic or still rings

    RecordProperty("kinetic_minimum", std::to_string(c.minimum) + " at " + std::to_string(c.minimum_time));
    RecordProperty("kinetic_final", std::to_string(c.final_kinetic));
    RecordProperty("total_largest", std::to_string(c.largest_total));
    RecordProperty("total_final", std::to_string(c.final_total));
    RecordProperty("momentum", fmt::format("{:g}", c.momentum));
}

}  // namespace
}  // namespace sandgraph
