#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mpm/layout.hpp"
#include "mpm/plate.hpp"
#include "stress/elastic.hpp"
#include "tests/support/macro_model.hpp"

namespace sandgraph {
namespace {

constexpr double cell = 0.1, q = 50e3, density = 2000, height = 0.6, width = 1.2;

struct Ride {
    Vec2 velocity;
    double gravity = 0;
    int per_cell = 1;
};

// A block between a moving rough plate and a surcharge, riding along with the plate from rest pressure.
support::MacroModel riding_block(const Ride& ride) {
    support::MacroModel model({0, 0, cell, 60, 60});
    const double x = 1.013, y = 1.027;
    model.points = mpm::lay_out({{x, y, x + width, y + height}, cell, ride.per_cell, density, {}});
    mpm::Points& points = model.points;
    std::vector<Stress> initial(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        initial[p] = {0, -q - density * ride.gravity * (points.row[p] + 0.5) * 2 * points.half, 0};
        points.vx[p] = ride.velocity.x(), points.vy[p] = ride.velocity.y();
    }
    model.law = std::make_unique<stress::Elastic>(stress::ElasticConstants{20e6, 0}, initial);
    const double base = q + density * ride.gravity * height;
    model.plate = mpm::RigidPlate{x + width / 2,
                                  y - 0.05,
                                  width / 2 + 0.2,
                                  0.05,
                                  ride.velocity,
                                  std::numbers::pi / 2,
                                  mpm::contact_stiffness(1, 20e6, cell),
                                  {base, 0, 0, 0}};
    model.surcharge = q;
    model.update.gravity = {0, -ride.gravity};
    model.set_time_step(0.3 * cell / std::sqrt(20e6 / density));
    model.start();
    return model;
}

double worst_stress_change(const support::MacroModel& model, const std::vector<Stress>& before) {
    double worst = 0;
    for (std::size_t p = 0; p < before.size(); ++p) {
        const Stress &a = model.points.stress[p], &b = before[p];
        worst = std::max({worst, std::fabs(a.xx - b.xx), std::fabs(a.yy - b.yy), std::fabs(a.xy - b.xy)});
    }
    return worst;
}

// Fifteen cells up and seven across: every phase of the grid is met.
TEST(CarriedBlock, UniformStressSurvivesCellCrossingToRoundOff) {
    for (const int per_cell : {1, 4}) {
        support::MacroModel model = riding_block({{1.4, 3.0}, 0, per_cell});
        const auto before = model.points.stress;
        const double kinetic = mpm::kinetic_energy(model.points);
        for (double t = 0; t < 0.5; t += model.update.dt) ASSERT_TRUE(model.step().good());
        EXPECT_LT(worst_stress_change(model, before), 1e-6 * q) << per_cell;
        EXPECT_NEAR(mpm::kinetic_energy(model.points) / kinetic, 1, 1e-9);
        EXPECT_NEAR(model.contact.reaction.total().y(), -q * width, 1e-6 * q);
    }
}

TEST(CarriedBlock, GravityStressStaysWithinHalfTheWeightOfARow) {
    support::MacroModel model = riding_block({{0.7, 1.5}, 9.81 * 5, 1});
    const auto before = model.points.stress;
    const double row = density * 9.81 * 5 * cell;
    double worst = 0;
    for (double t = 0; t < 0.5; t += model.update.dt) {
        ASSERT_TRUE(model.step().good());
        worst = std::max(worst, worst_stress_change(model, before));
    }
    EXPECT_LT(worst, 0.5 * row);
    RecordProperty("worst_over_row", std::to_string(worst / row));
}

}  // namespace
}  // namespace sandgraph
