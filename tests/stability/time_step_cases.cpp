#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.hpp"
#include "stability/ground.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

// Largest kinetic energy, share of the kick's, of an undamped column kicked at random; stops once it has
// grown 4 times.
double growth(double courant, int steps, int grains) {
    GroundSpec spec;
    spec.soil = {0, 0, 0.8, 2};
    spec.grains = grains, spec.courant = courant, spec.damping = 0;
    Ground ground(spec);
    ground.state().settings.scheme.pic_fraction = 0;
    Random random(7);
    mpm::Points& points = ground.points();
    for (std::size_t p = 0; p < points.size(); ++p)
        points.vx[p] = random.uniform(-0.001, 0.001), points.vy[p] = random.uniform(-0.001, 0.001);
    const double kick = ground.kinetic();
    double most = 0;
    for (int k = 0; k < steps && most < 4 * kick; ++k) {
        ground.step();
        most = std::max(most, ground.kinetic());
    }
    return most / kick;
}

// With one point a cell a step moves the stress of the shortest wave by dt^2 omega^2 of itself, omega = 2
// c/cell, while the points' velocities, averaged on the grid, know nothing of that wave: stable below dt^2
// omega^2 = 2, that is 0.71 cell/c.
void limit(Effort effort, Findings& found) {
    const int steps = effort == Effort::quick ? 1000 : 10'000, grains = effort == Effort::quick ? 100 : 400;
    found.driven = fmt::format("undamped column kicked at random, steps of C cell/c, {} steps", steps);
    double stable = 0;
    for (int c = 40; c < 96; c += 5) {
        if (growth(0.01 * c, steps, grains) > 2) break;
        stable = 0.01 * c;
    }
    constexpr double asked = 0.45;  // at most, by a scene: mpm::time_step
    found.at_most("kinetic energy over the kick's at 0.95 of what a scene can ask for",
                  growth(0.95 * asked, steps, grains), 2);
    found.within("largest stable C, in steps of 0.05", stable, asked, 0.75);
    found.because("0.71 for small waves; packings that rub and gap gain energy over long times from less on");
}

constexpr std::array table = {
    Case{"step.limit", limit},
};

}  // namespace

std::span<const Case> time_step_cases() { return table; }

}  // namespace sandgraph::stability
