#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mpm/layout.hpp"
#include "stress/elastic.hpp"
#include "tests/support/macro_model.hpp"

namespace sandgraph {
namespace {

constexpr double young = 1e6, density = 1000;

// One cell on rollers with a free top; `per_cell` points.
support::MacroModel element(int per_cell, mpm::Side right) {
    support::MacroModel model({0, 0, 1, 2, 2});
    model.points = mpm::lay_out({{0, 0, 1, 1}, 1, per_cell, density, {}});
    model.law = std::make_unique<stress::Elastic>(stress::ElasticConstants{young, 0.25},
                                                  std::vector<Stress>(model.points.size()));
    model.update.boundaries = {mpm::Side::mirror, right, mpm::Side::mirror, mpm::Side::free};
    model.update.damping = 0.5;
    model.advance.pic = 0.05;  // points of one cell have modes that the grid does not see
    model.set_time_step(0.05 / std::sqrt(young / density));
    model.start();
    return model;
}

double worst(const mpm::Points& points, double xx, double yy) {
    double w = 0;
    for (const Stress& s : points.stress)
        w = std::max({w, std::fabs(s.xx - xx), std::fabs(s.yy - yy), std::fabs(s.xy)});
    return w;
}

TEST(OneElement, FollowsARampOfTractionToItsEnd) {
    for (const int per_cell : {1, 4}) {
        support::MacroModel model = element(per_cell, mpm::Side::free);
        for (double t = 0; t < 15; t += model.update.dt) {
            model.surcharge = -std::min(1.0, t / 0.5);  // pulls
            model.step();
        }
        EXPECT_LT(worst(model.points, 0, 1), per_cell == 1 ? 1e-6 : 1e-5) << per_cell;
    }
}

TEST(OneElement, SettlesUnderASuddenLoad) {
    support::MacroModel model = element(4, mpm::Side::free);
    model.surcharge = 1;
    model.steps(30000);
    EXPECT_LT(worst(model.points, 0, -1), 1e-6);
}

}  // namespace
}  // namespace sandgraph
