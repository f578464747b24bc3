#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stress/mohr_coulomb.hpp"
#include "tests/support/bare_spec.hpp"
#include "tests/support/memory_archive.hpp"

namespace sandgraph {
namespace {

constexpr double cell = 0.1, density = 2200, gravity = 9.81, degree = std::numbers::pi / 180;
const stress::MohrCoulombConstants sand{20e6, 0.3, 32 * degree, 0, 10};

struct Setting {
    bool half = true;    // symmetry plane at x = 0
    double rate = 0;     // [m/s]
    double depth = 1.0;  // surface to the plate's top [m]
    double K0 = 1;
    int per_cell = 1;
    double thickness = 0.1;  // [m]
};

std::unique_ptr<stress::Law> sand_at_rest(const mpm::Points& points, double height, double K0) {
    std::vector<Stress> initial(points.size());
    std::vector<double> zz(points.size());
    for (std::size_t p = 0; p < initial.size(); ++p) {
        const double yy = -density * gravity * (height - points.y[p]);
        initial[p] = {K0 * yy, yy, 0};
        zz[p] = K0 * yy;
    }
    return std::make_unique<stress::MohrCoulomb>(sand, initial, zz);
}

// A plate 1 m wide in 4 m of ground at rest, 1 m above the base, pulled at once.
simulation::Spec ground_with_plate(const Setting& s) {
    const double height = s.depth + 1 + s.thickness, left = s.half ? 0 : -2, thick = s.thickness / 2;
    simulation::Spec spec;
    spec.grid = {left, 0, cell, s.half ? 20 : 40, static_cast<int>(std::ceil(height / cell)) + 6};
    spec.ground.extent = {left, 0, 2, height};
    spec.ground.points_per_cell = s.per_cell;
    spec.ground.density = density;
    spec.gravity = {0, -gravity};
    spec.law = [height, K0 = s.K0](const mpm::Points& points) { return sand_at_rest(points, height, K0); };
    mpm::RigidPlate plate{0, 1 + thick, 0.5, thick};
    plate.friction_angle = std::numbers::pi / 2;
    plate.rest = mpm::rest_pressure(0, density * gravity, height - plate.y, s.K0);
    spec.bodies = {{plate, {Vec2(0, 1), s.rate}}};
    return spec;
}

const mpm::Reaction& reaction(const simulation::Simulation& model) {
    return model.state().bodies.front().contact.reaction;
}

TEST(PlateAtRest, StaysAtRest) {
    for (const bool half : {true, false}) {
        simulation::Simulation model(ground_with_plate({half, 0, 1.0, 0.6}));
        const auto before = model.state().points.stress;
        support::steps(model, 2000);
        double worst = 0;
        for (std::size_t p = 0; p < before.size(); ++p)
            worst = std::max({worst, std::fabs(model.state().points.stress[p].yy - before[p].yy),
                              std::fabs(model.state().points.stress[p].xy)});
        EXPECT_LT(worst, 1e-3);  // [Pa]
        EXPECT_LT(mpm::kinetic_energy(model.state().points), 1e-12);
        // What is left is the plate's buoyancy: rho g times its volume.
        const double share = half ? 0.5 : 1;
        EXPECT_NEAR(reaction(model).total().y(), share * density * gravity * 0.1, 1e-3);
    }
}

TEST(PulledPlate, OpensACavityWithoutTension) {
    simulation::Simulation model(ground_with_plate({true, 0.1, 1.0, 1, 4, 0.05}));  // thinner than a cell
    const double start = model.state().bodies.front().plate.y;
    double least = 0, stretch = -1;
    while (model.state().bodies.front().plate.y - start < 0.05) {
        model.step();
        least = std::min(least, reaction(model).face(mpm::Face::bottom).y());
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(reaction(model).face(mpm::Face::bottom).y(), 0);
    // Soil below the middle of the plate has let go and stays where it was: it is not drawn up through the
    // plate.
    for (std::size_t p = 0; p < model.state().points.size(); ++p) {
        if (model.state().points.x[p] > 0.2 || model.state().points.y[p] > start ||
            model.state().points.y[p] < start - 0.15)
            continue;
        stretch = std::max(stretch, model.state().points.F[p](1, 1) - 1);
        EXPECT_GT(model.state().points.stress[p].yy, -2 * density * gravity * cell);  // its own weight
    }
    EXPECT_GT(stretch, -1);  // some point was looked at
    EXPECT_LT(stretch, 0.01);
    RecordProperty("stretch_below", std::to_string(stretch));
}

TEST(PulledPlate, HalfModelCarriesHalfTheLoad) {
    simulation::Simulation half(ground_with_plate({true, 0.1, 0.6, 1, 4, 0.05}));
    simulation::Simulation whole(ground_with_plate({false, 0.1, 0.6, 1, 4, 0.05}));
    for (int k = 0; k < 150; ++k) {
        half.step();
        whole.step();
        const double a = reaction(half).total().y(), b = reaction(whole).total().y();
        ASSERT_NEAR(2 * a, b, 1e-6 * std::fabs(b)) << k;
    }
}

TEST(PulledPlate, GoesOnFromACheckpointBitForBit) {
    const Setting setting{true, 0.1, 0.6, 1, 4, 0.05};
    simulation::Simulation straight(ground_with_plate(setting)), resumed(ground_with_plate(setting));
    support::steps(straight, 100);
    support::MemoryArchive memory;
    straight.archive(memory);
    memory.read_from_now_on();
    resumed.archive(memory);
    support::steps(straight, 100);
    support::steps(resumed, 100);
    EXPECT_EQ(straight.state().points.x, resumed.state().points.x);
    EXPECT_EQ(straight.state().points.vy, resumed.state().points.vy);
    EXPECT_EQ(straight.state().points.stress, resumed.state().points.stress);
    EXPECT_EQ(straight.state().bodies.front().contact.slip, resumed.state().bodies.front().contact.slip);
    EXPECT_EQ(reaction(straight).total(), reaction(resumed).total());
}

TEST(PulledPlate, WorkAndEnergyBalance) {
    simulation::Simulation model(ground_with_plate({true, 0.1, 1.0, 1}));
    const mpm::RigidPlate& plate = model.state().bodies.front().plate;
    const double potential = mpm::gravity_potential(model.state().points, {0, -gravity});
    double plate_work = 0;
    while (model.travel() < 0.02) {
        model.step();
        plate_work += mpm::plate_work(plate, reaction(model), model.state().settings.dt);
    }
    const double lifted = mpm::gravity_potential(model.state().points, {0, -gravity}) - potential;
    const double stored = model.state().stress_work + lifted + mpm::kinetic_energy(model.state().points);
    EXPECT_LE(stored, plate_work * 1.001);  // the rest went into damping
    EXPECT_GT(stored, plate_work * 0.9);
    RecordProperty("stored_over_plate_work", std::to_string(stored / plate_work));
}

// Of the penalty springs of the contact [J/m].
double spring_energy(const simulation::Simulation& model) {
    const graph::Body& body = model.state().bodies.front();
    double sum = 0;
    for (const mpm::ContactPoint& t : body.contact.points) {
        const double pressed = std::max(t.penetration, 0.0), slip = body.contact.slip[std::size_t(t.point)];
        sum += 0.5 * body.plate.stiffness * t.length * (pressed * pressed + slip * slip);
    }
    return sum;
}

// Work of plate and surcharge = of stress, weight, damping and transfer + kinetic energy + springs of the
// contact. A rough plate does not slip. The drag is large here, so that it must be accounted for.
TEST(PulledPlate, EnergyBalancesWithDampingAndPic) {
    constexpr double surcharge = 5e3;
    simulation::Spec spec = ground_with_plate({true, 0.2, 1.0, 1});
    spec.scheme.damping = 0.3, spec.scheme.pic_fraction = 0.05, spec.surcharge = surcharge;
    const double height = spec.ground.extent.y1;
    spec.bodies[0].plate.rest =
        mpm::rest_pressure(surcharge, density * gravity, height - spec.bodies[0].plate.y);
    spec.law = [height](const mpm::Points& points) {
        std::vector<Stress> initial(points.size());
        std::vector<double> zz(points.size());
        for (std::size_t p = 0; p < initial.size(); ++p) {
            zz[p] = -surcharge - density * gravity * (height - points.y[p]);
            initial[p] = {zz[p], zz[p], 0};
        }
        return std::make_unique<stress::MohrCoulomb>(sand, initial, zz);
    };
    simulation::Simulation model(spec);
    const graph::GroundState& state = model.state();
    const auto top = [&] {
        double sum = 0;
        for (const auto p : state.points.surface)
            sum += state.points.y[std::size_t(p)] * 2 * state.points.half;
        return sum;
    };
    model.step();
    const double potential = mpm::gravity_potential(state.points, {0, -gravity}), surface = top();
    const double springs = spring_energy(model), kinetic = mpm::kinetic_energy(state.points),
                 strain = state.stress_work;
    const mpm::NodeWork nodes = state.node_work;
    double plate_work = 0;
    while (model.travel() < 0.02) {
        model.step();
        plate_work += mpm::plate_work(state.bodies[0].plate, reaction(model), state.settings.dt);
    }
    const double damping = state.node_work.damping - nodes.damping;
    const double transfer =
        state.node_work.gained - nodes.gained - (mpm::kinetic_energy(state.points) - kinetic);
    const double stored = state.stress_work - strain + mpm::gravity_potential(state.points, {0, -gravity}) -
                          potential + surcharge * (top() - surface) + mpm::kinetic_energy(state.points) -
                          kinetic + spring_energy(model) - springs;
    EXPECT_GT(damping, 0.02 * plate_work);
    EXPECT_GT(transfer, 0.02 * plate_work);
    EXPECT_NEAR(stored + damping + transfer, plate_work, 0.01 * plate_work);
    RecordProperty("missing", std::to_string((stored + damping + transfer) / plate_work - 1));
    RecordProperty("damping", std::to_string(damping / plate_work));
    RecordProperty("transfer", std::to_string(transfer / plate_work));
}

}  // namespace
}  // namespace sandgraph
