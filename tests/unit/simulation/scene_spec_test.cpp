#include "simulation/scene_spec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "mpm/audit.hpp"
#include "stress/elastic.hpp"

// From the words of a scene to ground, plate and programme, and what a plate feels before and as it is
// pulled.
namespace sandgraph::simulation {
namespace {

constexpr double kDensity = 2000;

scene::Scene small_scene(scene::Orientation orientation) {
    scene::Scene s;
    s.domain = {3, 2, 0.1, 1};
    s.anchor.orientation = orientation;
    s.anchor.width = 0.6, s.anchor.thickness = 0.2, s.anchor.embedment_ratio = 1.5;
    s.anchor.position = orientation == scene::Orientation::vertical ? 1.5 : 0;
    s.anchor.pull_rate = 0.5, s.anchor.ramp = 0.02, s.anchor.friction_angle = 0.4;
    s.ground.law = scene::Law::elastic;
    s.ground.surcharge = 5e3;
    s.ground.continuum.density = kDensity, s.ground.continuum.young = 5e7;
    return s;
}

// Under its weight and the surcharge, in rows of one cell.
packings::PreparedGround ground_of(const scene::Scene& s) {
    packings::PreparedGround ground;
    ground.density = kDensity;
    for (int row = 0; row < 20; ++row)
        ground.row_pressure.push_back(s.ground.surcharge + kDensity * 9.81 * 0.1 * (row + 0.5));
    return ground;
}

Spec spec(scene::Orientation orientation) {
    const scene::Scene s = small_scene(orientation);
    return spec_of(s, ground_of(s));
}

const mpm::Reaction& reaction(const Simulation& s) { return s.state().bodies.front().contact.reaction; }

TEST(SceneSpec, AHorizontalPlateLiesWithItsTopAtTheEmbedmentAndGoesUp) {
    const BodySpec body = spec(scene::Orientation::horizontal).bodies.at(0);
    EXPECT_NEAR(body.plate.y + body.plate.half_height, 2 - 0.9, 1e-12);
    EXPECT_NEAR(body.plate.half_width, 0.3, 1e-12);
    EXPECT_NEAR(body.plate.half_height, 0.1, 1e-12);
    EXPECT_EQ(body.plate.x, 0);
    EXPECT_EQ(body.programme.direction, Vec2(0, 1));
    EXPECT_EQ(body.plate.friction_angle, 0.4);
}

TEST(SceneSpec, AVerticalPlateStandsWithItsLowerEdgeAtTheEmbedmentAndGoesSideways) {
    const BodySpec body = spec(scene::Orientation::vertical).bodies.at(0);
    EXPECT_NEAR(body.plate.y - body.plate.half_height, 2 - 0.9, 1e-12);
    EXPECT_NEAR(body.plate.half_width, 0.1, 1e-12);
    EXPECT_NEAR(body.plate.half_height, 0.3, 1e-12);
    EXPECT_EQ(body.plate.x, 1.5);
    EXPECT_EQ(body.programme.direction, Vec2(1, 0));
}

TEST(SceneSpec, ThePlateFeelsTheOverburdenOfItsCentre) {
    for (const auto o : {scene::Orientation::horizontal, scene::Orientation::vertical}) {
        const BodySpec body = spec(o).bodies.at(0);
        const double gamma = kDensity * 9.81;
        EXPECT_NEAR(body.plate.rest.vertical, 5e3 + gamma * (2 - body.plate.y), 1e-9);
        EXPECT_NEAR(body.plate.rest.horizontal, body.plate.rest.vertical, 1e-9);
        EXPECT_NEAR(body.plate.rest.vertical_gradient, gamma, 1e-9);
        EXPECT_NEAR(body.plate.rest.horizontal_gradient, gamma, 1e-9);
    }
    const mpm::RestPressure r = mpm::rest_pressure(1e3, 20e3, 2, 0.5);
    EXPECT_EQ(r.vertical, 41e3);
    EXPECT_EQ(r.horizontal, 20.5e3);
    EXPECT_EQ(r.horizontal_gradient, 10e3);
}

TEST(SceneSpec, TheRampIsAShareOfTheWidthAfterATimeAtRest) {
    const Programme p = spec(scene::Orientation::horizontal).bodies.at(0).programme;
    EXPECT_NEAR(p.ramp, 0.02 * 0.6, 1e-15);
    EXPECT_EQ(p.rate, 0.5);
    EXPECT_GT(p.settle, 0);
    EXPECT_EQ(rate_at(p, p.settle), 0);
}

TEST(SceneSpec, GravitySurchargeAndSchemeAreTheScenes) {
    scene::Scene s = small_scene(scene::Orientation::horizontal);
    s.ground.gravity = 3, s.mpm.damping = 0.07;
    const Spec made = spec_of(s, ground_of(s));
    EXPECT_EQ(made.gravity, Vec2(0, -3));
    EXPECT_EQ(made.surcharge, 5e3);
    EXPECT_EQ(made.scheme.damping, 0.07);
    EXPECT_EQ(made.width, 0.6);
    EXPECT_EQ(made.ground.density, kDensity);
    EXPECT_EQ(made.grid.nx, 31) << "half a cell more on either side";
    EXPECT_NEAR(made.grid.x0, -0.05, 1e-15);
    EXPECT_TRUE(made.boundaries.between_x);
    s.domain.edges = scene::Edges::on_nodes;
    EXPECT_EQ(spec_of(s, ground_of(s)).grid.nx, 30);
    EXPECT_GE(made.grid.ny * 0.1, 2 + 0.4 * 0.6) << "room for the pull";
}

TEST(SceneSpec, LoadsCountInTheOverburdenTimesTheWidth) {
    scene::Scene s = small_scene(scene::Orientation::horizontal);
    const double gamma = kDensity * 9.81;
    EXPECT_NEAR(unit_load(s, ground_of(s)), 0.6 * (gamma * 0.9 + 5e3), 1e-9);
    EXPECT_NEAR(equivalent_embedment(s, ground_of(s)), 0.9 + 5e3 / gamma, 1e-12);
    EXPECT_EQ(whole_plate_factor(s), 2);
    s.anchor.orientation = scene::Orientation::vertical;
    EXPECT_EQ(whole_plate_factor(s), 1);
}

// A fifth of a second of ramp.
TEST(Ramp, IsASmoothstepOfTime) {
    const Programme p{Vec2(0, 1), 0.1, 0.01, 0.05};
    for (const double s : {0.1, 0.25, 0.5, 0.75, 0.9})
        EXPECT_NEAR(rate_at(p, 0.05 + 0.2 * s), 0.1 * s * s * (3 - 2 * s), 1e-15) << s;
    EXPECT_EQ(rate_at(p, 0.05 + 0.2001), 0.1);
    EXPECT_LT(rate_at(p, 0.05 + 0.199), 0.1);
}

// Of any point since the start [m].
double moved_most(const mpm::Points& now, const mpm::Points& start) {
    double most = 0;
    for (std::size_t k = 0; k < now.size(); ++k)
        most = std::max(most, std::hypot(now.x[k] - start.x[k], now.y[k] - start.y[k]));
    return most;
}

// Grounds at K0 = 1 press a vertical plate alike from both sides.
TEST(PlateAtRest, AVerticalOneFeelsNoLoadAndDoesNotMoveTheGround) {
    const scene::Scene s = small_scene(scene::Orientation::vertical);
    const auto simulation = simulation_of(s, ground_of(s));
    const mpm::Points start = simulation->state().points;
    for (int k = 0; k < 20; ++k) simulation->step(Vec2(0, 0));
    EXPECT_LT(moved_most(simulation->state().points, start), 1e-11);
    const double p = 5e3 + kDensity * 9.81 * (2 - simulation->state().bodies[0].plate.y);
    EXPECT_NEAR(simulation->leading(), p * 0.6, 1e-6 * p);
    EXPECT_NEAR(simulation->trailing(), -p * 0.6, 1e-6 * p);
    EXPECT_NEAR(simulation->load(), 0, 1e-6 * p);
}

// One half of it; the buoyancy of the ground that it stands for is left.
TEST(PlateAtRest, AHorizontalOneFeelsTheGroundAboveAndBelow) {
    const scene::Scene s = small_scene(scene::Orientation::horizontal);
    const auto simulation = simulation_of(s, ground_of(s));
    const mpm::Points start = simulation->state().points;
    for (int k = 0; k < 20; ++k) simulation->step(Vec2(0, 0));
    EXPECT_LT(moved_most(simulation->state().points, start), 1e-11);
    const double gamma = kDensity * 9.81;
    EXPECT_NEAR(simulation->leading(), (5e3 + gamma * 0.9) * 0.3, 1e-3);
    EXPECT_NEAR(simulation->trailing(), -(5e3 + gamma * 1.1) * 0.3, 1e-3);
    EXPECT_NEAR(simulation->load(), -gamma * 0.2 * 0.3, 1e-3);
}

class PlateAtRestUnderK0 : public testing::TestWithParam<std::tuple<scene::Law, double>> {};

TEST_P(PlateAtRestUnderK0, FeelsTheHorizontalStressAndMovesNothing) {
    scene::Scene s = small_scene(scene::Orientation::vertical);
    std::tie(s.ground.law, s.ground.k0) = GetParam();
    const auto simulation = simulation_of(s, ground_of(s));
    const mpm::Points start = simulation->state().points;
    for (std::size_t p = 0; p < start.size(); ++p)
        EXPECT_NEAR(start.stress[p].xx, s.ground.k0 * start.stress[p].yy, 1e-9);
    for (int k = 0; k < 20; ++k) simulation->step(Vec2(0, 0));
    EXPECT_LT(moved_most(simulation->state().points, start), 1e-11);
    const double p = s.ground.k0 * (5e3 + kDensity * 9.81 * (2 - simulation->state().bodies[0].plate.y));
    EXPECT_NEAR(simulation->leading(), p * 0.6, 1e-6 * p);
    EXPECT_NEAR(simulation->load(), 0, 1e-6 * p);
}

TEST_P(PlateAtRestUnderK0, GroundWithoutAPlateMovesNothing) {
    scene::Scene s = small_scene(scene::Orientation::horizontal);
    std::tie(s.ground.law, s.ground.k0) = GetParam();
    s.anchor.present = false;
    const auto simulation = simulation_of(s, ground_of(s));
    const mpm::Points start = simulation->state().points;
    for (int k = 0; k < 200; ++k) simulation->step();
    EXPECT_LT(moved_most(simulation->state().points, start), 1e-10);
    EXPECT_LT(mpm::kinetic_energy(simulation->state().points), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Laws, PlateAtRestUnderK0,
                         testing::Combine(testing::Values(scene::Law::elastic, scene::Law::mohr_coulomb),
                                          testing::Values(0.4, 0.5, 2.5)));

// Ahead the ground is pressed, behind it is relieved.
TEST(PlatePulled, SidewaysLoadsItsRightFaceAndRelievesItsLeft) {
    const scene::Scene s = small_scene(scene::Orientation::vertical);
    const auto simulation = simulation_of(s, ground_of(s));
    simulation->step(Vec2(0, 0));
    const mpm::Reaction rest = reaction(*simulation);
    EXPECT_NEAR(simulation->leading(), -rest.face(mpm::Face::right).x(), 1e-9);
    EXPECT_NEAR(simulation->trailing(), -rest.face(mpm::Face::left).x(), 1e-9);
    const double leading = simulation->leading(), trailing = simulation->trailing();
    EXPECT_NEAR(leading, -trailing, 1e-6 * leading);
    for (int k = 0; k < 30; ++k) simulation->step(Vec2(0.05, 0));
    EXPECT_GT(simulation->leading(), leading);
    EXPECT_GT(simulation->trailing(), trailing) << "it held the plate back by more before";
    EXPECT_GT(simulation->load(), 0);
    EXPECT_LT(reaction(*simulation).total().x(), 0);
    EXPECT_NEAR(simulation->travel(), 30 * 0.05 * simulation->state().settings.dt, 1e-12);
}

TEST(PlatePulled, UpwardsLoadsItsTopFace) {
    const scene::Scene s = small_scene(scene::Orientation::horizontal);
    const auto simulation = simulation_of(s, ground_of(s));
    simulation->step(Vec2(0, 0));
    EXPECT_NEAR(simulation->leading(), -reaction(*simulation).face(mpm::Face::top).y(), 1e-9);
    EXPECT_NEAR(simulation->trailing(), -reaction(*simulation).face(mpm::Face::bottom).y(), 1e-9);
    EXPECT_LT(simulation->trailing(), 0);
}

// Ground that slides to the right as a block is held at its base and let slide along its walls.
TEST(DefaultBoundaries, TheBaseIsRoughAndTheWallsAreSmooth) {
    Spec spec;
    spec.grid = {0, 0, 0.1, 10, 14};
    spec.ground.extent = {0, 0, 1, 1};
    spec.ground.velocity = [](double, double) { return Vec2(0.1, 0.2); };
    spec.gravity = Vec2::Zero();
    spec.law = [](const mpm::Points& points) {
        return std::make_unique<stress::Elastic>(stress::ElasticConstants{1e6, 0.3},
                                                 std::vector<Stress>(points.size()));
    };
    Simulation simulation(spec);
    simulation.step();
    const mpm::Grid& grid = simulation.state().grid;
    const auto motion = [&](int i, int j) { return grid.fields[0].motion[grid.shape.index(i, j)]; };
    for (int i = 0; i <= 10; ++i) EXPECT_EQ(motion(i, 0).vx, 0) << i;
    for (int i = 0; i <= 10; ++i) EXPECT_EQ(motion(i, 0).vy, 0) << i;
    for (const int wall : {0, 10}) {
        EXPECT_EQ(motion(wall, 5).vx, 0);
        EXPECT_NEAR(motion(wall, 5).vy, 0.2, 1e-6);
    }
    EXPECT_NEAR(motion(5, 5).vx, 0.1, 1e-6);
    EXPECT_NEAR(motion(5, 10).vy, 0.2, 1e-6) << "the surface is free";
}

}  // namespace
}  // namespace sandgraph::simulation
