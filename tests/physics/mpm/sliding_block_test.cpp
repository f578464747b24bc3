#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mpm/layout.hpp"
#include "mpm/plate.hpp"
#include "stress/elastic.hpp"
#include "tests/support/macro_model.hpp"

namespace sandgraph {
namespace {

constexpr double cell = 0.1, density = 2000, gravity = 9.81, young = 1e7, length = 0.8, height = 0.2;
constexpr double slope = std::numbers::pi / 6;

// An incline of 30 degrees: the plate lies level and gravity is turned.
support::MacroModel incline(double friction) {
    support::MacroModel model({0, 0, cell, 50, 10});
    const double x = 1.02, y = 0.33;
    model.points = mpm::lay_out({{x, y, x + length, y + height}, cell, 4, density, {}});
    const Vec2 g = gravity * Vec2(std::sin(slope), -std::cos(slope));
    std::vector<Stress> initial(model.points.size());
    for (std::size_t p = 0; p < initial.size(); ++p)
        initial[p].yy = density * g.y() * (model.points.row[p] + 0.5) * 2 * model.points.half;
    model.law = std::make_unique<stress::Elastic>(stress::ElasticConstants{young, 0.2}, initial);
    const double base = -density * g.y() * height;
    model.plate = mpm::RigidPlate{2.5,
                                  y - 0.1,
                                  2.3,
                                  0.1,
                                  Vec2::Zero(),
                                  std::atan(friction),
                                  mpm::contact_stiffness(1, model.law->p_wave_modulus(), cell),
                                  {base, 0, 0, 0}};
    model.update.gravity = g;
    model.set_time_step(0.3 * cell / std::sqrt(model.law->p_wave_modulus() / density));
    model.start();
    return model;
}

// Sliding from the first step, faster than the block's own vibrations: else the contact's elastic shear takes
// its few microns first, and the base sticks now and then.
void set_sliding(support::MacroModel& model, double speed) {
    std::fill(model.points.vx.begin(), model.points.vx.end(), speed);
    std::fill(model.contact.slip.begin(), model.contact.slip.end(), 1.0);
    std::fill(model.contact.face.begin(), model.contact.face.end(),
              static_cast<std::uint8_t>(mpm::Face::top));
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
    support::MacroModel model = incline(friction);
    if (speed > 0) set_sliding(model, speed);
    const double start = mean_x(model.points), dt = model.update.dt;
    const int steps = static_cast<int>(std::lround(time / dt));
    model.steps(steps);
    const double t = steps * dt, a = gravity * (std::sin(slope) - friction * std::cos(slope));
    return {mean_x(model.points) - start, speed * t + 0.5 * a * t * (t + dt)};
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
