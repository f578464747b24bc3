#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/bare_spec.hpp"

namespace sandgraph {
namespace {

constexpr double cell = 0.1, density = 2000, gravity = 9.81, young = 1e7, length = 0.8, height = 0.2;
constexpr double slope = std::numbers::pi / 6;

// An incline of 30 degrees: the plate lies level and gravity is turned.
simulation::Spec incline(double friction) {
    simulation::Spec spec = support::bare_spec({0, 0, cell, 50, 10});
    const double x = 1.02, y = 0.33;
    spec.ground.extent = {x, y, x + length, y + height};
    spec.ground.points_per_cell = 4;
    spec.ground.density = density;
    spec.gravity = gravity * Vec2(std::sin(slope), -std::cos(slope));
    const double weight = -density * spec.gravity.y();
    spec.law = support::elastic({young, 0.2}, [weight](const mpm::Points& points, std::size_t p) {
        return Stress{0, -weight * (points.row[p] + 0.5) * 2 * points.half, 0};
    });
    mpm::RigidPlate plate{2.5, y - 0.1, 2.3, 0.1};
    plate.friction_angle = std::atan(friction);
    plate.rest.vertical = weight * height;
    spec.bodies = {{plate, {}}};
    spec.scheme.courant = 0.3;
    return spec;
}

// Sliding from the first step, faster than the block's own vibrations: else the contact's elastic shear takes
// its few microns first, and the base sticks now and then.
void set_sliding(graph::GroundState& state, double speed) {
    mpm::Contact& contact = state.bodies.front().contact;
    std::fill(state.points.vx.begin(), state.points.vx.end(), speed);
    std::fill(contact.slip.begin(), contact.slip.end(), 1.0);
    std::fill(contact.face.begin(), contact.face.end(), static_cast<std::uint8_t>(mpm::Face::top));
}

double mean_x(const mpm::Points& points) {
    double sum = 0;
    for (const double x : points.x) sum += x;
    return sum / static_cast<double>(points.size());
}

struct Slide {
    double distance = 0, exact = 0;  // [m]
};

// The exact distance in the time stepping used, v before x: s = v0 t + a t (t + dt) / 2.
Slide slide(double friction, double time, double speed) {
    simulation::Simulation model(incline(friction));
    if (speed > 0) set_sliding(model.state(), speed);
    const double start = mean_x(model.state().points), dt = model.state().settings.dt;
    const int steps = static_cast<int>(std::lround(time / dt));
    support::steps(model, steps);
    const double t = steps * dt, a = gravity * (std::sin(slope) - friction * std::cos(slope));
    return {mean_x(model.state().points) - start, speed * t + 0.5 * a * t * (t + dt)};
}

TEST(SlidingBlock, AcceleratesByCoulombsLaw) {
    for (const double friction : {0.0, 0.1, 0.3})
        for (const double t : {0.33, 0.66}) {
            const Slide s = slide(friction, t, 0.2);
            EXPECT_NEAR(s.distance, s.exact, 2e-4 * s.exact) << friction << " " << t;
        }
}

TEST(SlidingBlock, SticksWhenFrictionSuffices) {  // tan 30 deg = 0.577
    EXPECT_LT(std::fabs(slide(0.7, 0.66, 0).distance), 1e-3);
    EXPECT_LT(std::fabs(slide(1e16, 0.66, 0).distance), 1e-3);
}

}  // namespace
}  // namespace sandgraph
