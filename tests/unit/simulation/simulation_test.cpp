#include "simulation/simulation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/bare_spec.hpp"

namespace sandgraph::simulation {
namespace {

TEST(Programme, RestsThenRisesToItsRateOverTheRamp) {
    const Programme p{Vec2(0, 1), 0.05, 0.01, 0.1};
    EXPECT_EQ(rate_at(p, 0.1), 0);
    EXPECT_GT(rate_at(p, 0.2), 0);
    EXPECT_EQ(rate_at(p, 0.5), 0.05);  // the ramp takes 2 0.01 / 0.05 = 0.4 s
    double travel = 0;
    for (int k = 0; k < 4000; ++k) travel += 1e-4 * rate_at(p, 0.1 + 1e-4 * (k + 0.5));
    EXPECT_NEAR(travel, 0.01, 1e-9);
}

TEST(Programme, WithoutARampIsAtItsRateAtOnce) {
    EXPECT_EQ(rate_at({Vec2(0, 1), 0.05}, 1e-9), 0.05);
    EXPECT_EQ(rate_at({}, 1), 0);
}

// A block of 4 x 4 points that lies on nothing.
Spec block() {
    Spec spec = support::bare_spec({0, 0, 0.1, 10, 10});
    spec.ground.extent = {0.3, 0.3, 0.7, 0.7};
    spec.law = support::elastic({1e6, 0.3});
    return spec;
}

BodySpec body_at(double y) {
    BodySpec body{mpm::RigidPlate{0.5, y, 0.2, 0.05}, {Vec2(0, 1), 0.5}};
    return body;
}

TEST(Simulation, OfGroundAloneCountsTimeOnly) {
    Spec spec = block();
    spec.ground.inside = [](double x, double) { return x < 0.5; };
    spec.ground.velocity = [](double, double) { return Vec2(0.1, -0.2); };
    Simulation simulation(spec);
    ASSERT_EQ(simulation.state().points.size(), 8u);
    const double y = simulation.state().points.y.front();
    for (int k = 0; k < 10; ++k) simulation.step();
    EXPECT_EQ(simulation.steps(), 10);
    EXPECT_NEAR(simulation.time(), 10 * simulation.state().settings.dt, 1e-15);
    EXPECT_EQ(simulation.mark(), simulation.time());
    EXPECT_EQ(simulation.d_over_B(), 0);
    EXPECT_NEAR(simulation.state().points.y.front(), y - 0.2 * simulation.time(), 1e-12);
}

TEST(Simulation, LeavesOutTheGroundWhereABodyStandsAndDrivesIt) {
    Spec spec = block();
    spec.bodies = {body_at(0.65)};
    spec.width = 0.4;
    Simulation simulation(spec);
    EXPECT_EQ(simulation.state().points.size(), 12u);
    simulation.step();
    simulation.step(Vec2(3, 0));  // across its direction
    const double dt = simulation.state().settings.dt;
    EXPECT_DOUBLE_EQ(simulation.travel(), 0.5 * dt);
    EXPECT_DOUBLE_EQ(simulation.mark(), 0.5 * dt / 0.4);
    EXPECT_NEAR(simulation.state().bodies.front().plate.x, 0.5 + 3 * dt, 1e-15);
}

TEST(Simulation, DrivesEveryBodyByItsOwnProgramme) {
    Spec spec = block();
    spec.bodies = {body_at(0.65), body_at(0.25)};
    spec.bodies[1].programme.direction = Vec2(1, 0);
    Simulation simulation(spec);
    simulation.step();
    const auto& bodies = simulation.state().bodies;
    EXPECT_GT(bodies[0].plate.y, 0.65);
    EXPECT_EQ(bodies[0].plate.x, 0.5);
    EXPECT_GT(bodies[1].plate.x, 0.5);
    EXPECT_EQ(bodies[1].plate.y, 0.25);
    EXPECT_NEAR(simulation.travel(1), bodies[1].plate.x - 0.5, 1e-15);
    const double x = bodies[1].plate.x;
    simulation.step(Vec2(0, 0));  // the first at rest, the second as its programme says
    EXPECT_EQ(bodies[0].plate.velocity, Vec2(0, 0));
    EXPECT_GT(bodies[1].plate.x, x);
}

TEST(Simulation, SaysWhichPointLeftTheGrid) {
    Spec spec = block();
    spec.ground.velocity = [](double, double) { return Vec2(0, 1000); };
    Simulation simulation(spec);
    EXPECT_THROW(support::steps(simulation, 100), std::runtime_error);
}

}  // namespace
}  // namespace sandgraph::simulation
