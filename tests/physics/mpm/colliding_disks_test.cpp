#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mpm/layout.hpp"
#include "stress/elastic.hpp"
#include "tests/support/macro_model.hpp"

namespace sandgraph {
namespace {

// Sulsky's disks: r 0.2 m, E 1000 Pa, nu 0.3, rho 1000 kg/m3, centres (0.3, 0.3) and (0.7, 0.7) m,
// towards each other at (0.1, 0.1) m/s: they meet at (0.4 sqrt 2 - 2 r) / (0.2 sqrt 2) = 0.586 s.
constexpr double cell = 0.05, r = 0.2, density = 1000, speed = 0.1;

void keep(mpm::Points& points, const std::vector<std::size_t>& chosen) {
    const mpm::Points all = points;
    points = {};
    points.half = all.half;
    for (const std::size_t p : chosen) {
        points.x.push_back(all.x[p]), points.y.push_back(all.y[p]);
        points.mass.push_back(all.mass[p]), points.volume0.push_back(all.volume0[p]);
    }
    points.volume = points.volume0;
    mpm::resize(points, chosen.size());
}

mpm::Points disks() {
    mpm::Points points = mpm::lay_out({{0, 0, 1, 1}, cell, 4, density, {}});
    std::vector<std::size_t> inside;
    for (std::size_t p = 0; p < points.size(); ++p)
        for (const double c : {0.3, 0.7})
            if (std::hypot(points.x[p] - c, points.y[p] - c) < r) inside.push_back(p);
    keep(points, inside);
    for (std::size_t p = 0; p < points.size(); ++p)
        points.vx[p] = points.vy[p] = points.x[p] < 0.5 ? speed : -speed;
    return points;
}

struct Collision {
    double minimum = 1, minimum_time = 0, final_kinetic = 0, final_total = 0, largest_total = 0, momentum = 0;
};

Collision collide() {
    support::MacroModel model({-0.5, -0.5, cell, 40, 40});
    model.points = disks();
    model.law = std::make_unique<stress::Elastic>(stress::ElasticConstants{1000, 0.3},
                                                  std::vector<Stress>(model.points.size()));
    model.set_time_step(0.1 * cell / std::sqrt(model.law->p_wave_modulus() / density));
    model.audit = true;
    model.start();
    Collision c;
    const double before = mpm::kinetic_energy(model.points);
    for (double t = 0; t < 3.5; t += model.update.dt) {
        EXPECT_TRUE(model.step().good());
        const double share = mpm::kinetic_energy(model.points) / before;
        if (share < c.minimum) c.minimum = share, c.minimum_time = t;
        c.momentum = std::max(c.momentum, mpm::momentum(model.points).norm());
        c.final_kinetic = share, c.final_total = share + model.work / before;
        c.largest_total = std::max(c.largest_total, c.final_total);
    }
    return c;
}

TEST(CollidingDisks, KeepZeroMomentumAndGiveTheirEnergyBack) {
    const Collision c = collide();
    EXPECT_LT(c.momentum, 1e-11);  // of 12.6 kg/m * 0.14 m/s each
    EXPECT_NEAR(c.minimum, 0.050, 0.02);
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
