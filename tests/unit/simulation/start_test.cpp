#include <gtest/gtest.h>

#include <cmath>

#include "simulation/history_points.hpp"
#include "tests/support/bare_spec.hpp"

// How a run begins: at rest, with a time step that its plate bears, and points for its log.
namespace sandgraph::simulation {
namespace {

TEST(Programme, IsAtRestAllTheWhileBeforeItsRamp) {
    const Programme p{Vec2(0, 1), 0.05, 0.01, 0.1};
    for (const double time : {0.0, 0.02, 0.05, 0.0999}) EXPECT_EQ(rate_at(p, time), 0) << time;
}

TEST(Simulation, ABodysPenaltyShortensTheTimeStepAndGroundAloneKnowsNone) {
    Spec spec = support::bare_spec({0, 0, 0.1, 10, 10});
    spec.ground.extent = {0.3, 0.3, 0.7, 0.7};
    spec.law = support::elastic({1e6, 0.3});
    spec.scheme.courant = 0.3, spec.scheme.contact_stiffness = 8;
    const double alone = Simulation(spec).state().settings.dt;
    spec.bodies = {{mpm::RigidPlate{0.5, 0.65, 0.2, 0.05}, {Vec2(0, 1), 0.5}}};
    EXPECT_NEAR(Simulation(spec).state().settings.dt / alone, 0.15 / 0.3, 1e-12);
}

double distance(const mpm::Rectangle& r, double x, double y) {
    return std::hypot(std::max({r.x0 - x, 0.0, x - r.x1}), std::max({r.y0 - y, 0.0, y - r.y1}));
}

TEST(HistoryPoints, AQuarterLiesAtThePlatesEndsAndAQuarterAboutIt) {
    Spec spec = support::bare_spec({0, 0, 0.1, 100, 100});
    spec.ground.extent = {0, 0, 10, 10};
    spec.law = support::elastic({1e6, 0.3});
    const Simulation simulation(spec);
    const mpm::Points& points = simulation.state().points;
    const mpm::Rectangle plate{4.5, 4.95, 5.5, 5.05};
    const auto chosen = history_points(points, plate, 1, 400, 3);
    ASSERT_EQ(chosen.size(), 400u);
    int ends = 0, about = 0;
    for (const std::int32_t id : chosen) {
        const auto p = static_cast<std::size_t>(id);
        const double x = points.x[p], y = points.y[p];
        ends +=
            std::min(distance({4.5, 4.95, 4.5, 5.05}, x, y), distance({5.5, 4.95, 5.5, 5.05}, x, y)) < 0.5;
        about += distance(plate, x, y) < 1.5;
    }
    // A half there by intent; of 200 spread over the whole some 20 fall within.
    EXPECT_GE(ends, 100);
    EXPECT_GE(about, 200);
    EXPECT_LT(about, 240);
}

}  // namespace
}  // namespace sandgraph::simulation
