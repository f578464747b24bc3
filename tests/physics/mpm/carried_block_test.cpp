#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/bare_spec.hpp"

namespace sandgraph {
namespace {

constexpr double cell = 0.1, q = 50e3, density = 2000, height = 0.6, width = 1.2;

struct Ride {
    Vec2 velocity;
    double gravity = 0;
    int per_cell = 1;
};

// A block between a moving rough plate and a surcharge, riding along with the plate from rest pressure.
simulation::Spec riding_block(const Ride& ride) {
    simulation::Spec spec = support::bare_spec({0, 0, cell, 60, 60});
    const double x = 1.013, y = 1.027, weight = density * ride.gravity;
    spec.ground.extent = {x, y, x + width, y + height};
    spec.ground.points_per_cell = ride.per_cell;
    spec.ground.density = density;
    spec.ground.velocity = [v = ride.velocity](double, double) { return v; };
    spec.law = support::elastic({20e6, 0}, [weight](const mpm::Points& points, std::size_t p) {
        return Stress{0, -q - weight * (points.row[p] + 0.5) * 2 * points.half, 0};
    });
    mpm::RigidPlate plate{x + width / 2, y - 0.05, width / 2 + 0.2, 0.05};
    plate.friction_angle = std::numbers::pi / 2;
    plate.rest.vertical = q + weight * height;
    spec.bodies = {{plate, {ride.velocity.normalized(), ride.velocity.norm()}}};
    spec.surcharge = q;
    spec.gravity = {0, -ride.gravity};
    spec.scheme.courant = 0.3;
    return spec;
}

double worst_stress_change(const mpm::Points& points, const std::vector<Stress>& before) {
    double worst = 0;
    for (std::size_t p = 0; p < before.size(); ++p) {
        const Stress &a = points.stress[p], &b = before[p];
        worst = std::max({worst, std::fabs(a.xx - b.xx), std::fabs(a.yy - b.yy), std::fabs(a.xy - b.xy)});
    }
    return worst;
}

// Fifteen cells up and seven across: every phase of the grid is met.
TEST(CarriedBlock, UniformStressSurvivesCellCrossingToRoundOff) {
    for (const int per_cell : {1, 4}) {
        simulation::Simulation model(riding_block({{1.4, 3.0}, 0, per_cell}));
        const mpm::Points& points = model.state().points;
        const auto before = points.stress;
        const double kinetic = mpm::kinetic_energy(points);
        while (model.time() < 0.5) model.step();
        EXPECT_LT(worst_stress_change(points, before), 1e-6 * q) << per_cell;
        EXPECT_NEAR(mpm::kinetic_energy(points) / kinetic, 1, 1e-9);
        EXPECT_NEAR(model.state().bodies.front().contact.reaction.total().y(), -q * width, 1e-6 * q);
    }
}

TEST(CarriedBlock, GravityStressStaysWithinHalfTheWeightOfARow) {
    simulation::Simulation model(riding_block({{0.7, 1.5}, 9.81 * 5, 1}));
    const auto before = model.state().points.stress;
    const double row = density * 9.81 * 5 * cell;
    double worst = 0;
    while (model.time() < 0.5) {
        model.step();
        worst = std::max(worst, worst_stress_change(model.state().points, before));
    }
    EXPECT_LT(worst, 0.5 * row);
    RecordProperty("worst_over_row", std::to_string(worst / row));
}

}  // namespace
}  // namespace sandgraph
