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
    ground.state().settings.pic = 0;
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
    for (double c = 0.5; c < 0.96; c += 0.05) {
        if (growth(c, steps, grains) > 2) break;
        stable = c;
    }
    found.at_most("kinetic energy over the kick's at 0.95 of what a scene can ask for, C = 0.475",
                  growth(0.95 * 0.5, steps, grains), 2);
    found.within("largest stable C", stable, 0.6, 0.75);
}

constexpr std::array table = {
    Case{"step.limit", limit},
};

}  // namespace

std::span<const Case> time_step_cases() { return table; }

}  // namespace sandgraph::stability
