#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/bare_spec.hpp"

namespace sandgraph {
namespace {

constexpr double young = 1e6, density = 1000;

// One cell on rollers with a free top; `per_cell` points.
simulation::Spec element(int per_cell, mpm::Side right) {
    simulation::Spec spec = support::bare_spec({0, 0, 1, 2, 2});
    spec.ground.points_per_cell = per_cell;
    spec.ground.density = density;
    spec.law = support::elastic({young, 0.25});
    spec.boundaries = {mpm::Side::mirror, right, mpm::Side::mirror, mpm::Side::free};
    spec.scheme.damping = 0.5;
    spec.scheme.pic_fraction = 0.05;              // points of one cell have modes that the grid does not see
    spec.scheme.courant = 0.05 * std::sqrt(1.2);  // M = 1.2 E: dt = 0.05 s of a wave of speed sqrt(E/rho)
    return spec;
}

double worst(const mpm::Points& points, double xx, double yy) {
    double w = 0;
    for (const Stress& s : points.stress)
        w = std::max({w, std::fabs(s.xx - xx), std::fabs(s.yy - yy), std::fabs(s.xy)});
    return w;
}

TEST(OneElement, FollowsARampOfTractionToItsEnd) {
    for (const int per_cell : {1, 4}) {
        simulation::Simulation model(element(per_cell, mpm::Side::free));
        while (model.time() < 15) {
            model.state().settings.surcharge = -std::min(1.0, model.time() / 0.5);  // pulls
            model.step();
        }
        EXPECT_LT(worst(model.state().points, 0, 1), per_cell == 1 ? 1e-6 : 1e-5) << per_cell;
    }
}

TEST(OneElement, SettlesUnderASuddenLoad) {
    simulation::Spec spec = element(4, mpm::Side::free);
    spec.surcharge = 1;
    simulation::Simulation model(spec);
    support::steps(model, 30000);
    EXPECT_LT(worst(model.state().points, 0, -1), 1e-6);
}

}  // namespace
}  // namespace sandgraph
