#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mpm/audit.hpp"
#include "simulation/frame_recorder.hpp"
#include "simulation/load_recorder.hpp"
#include "simulation/make_frame.hpp"
#include "simulation/region_recorder.hpp"
#include "tests/support/bare_spec.hpp"

// What recorders take from a running simulation, beside the same read off it.
namespace sandgraph::simulation {
namespace {

// A plate in a block under its own uniform pressure, pulled up from the first step on.
Spec pulled(double rate = 0.5) {
    Spec spec = support::bare_spec({0, 0, 0.1, 20, 24});
    spec.ground.extent = {0, 0, 2, 2};
    spec.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    spec.law = support::elastic({1e6, 0.3}, [](const mpm::Points&, std::size_t) {
        return Stress{-1e3, -2e3, 300};
    });
    spec.bodies = {{mpm::RigidPlate{1, 1, 0.4, 0.1}, {Vec2(0, 1), rate}}};
    spec.bodies[0].plate.rest = {2e3, 1e3, 0, 0};
    spec.width = 0.8, spec.scheme.mass_scaling = 3;
    return spec;
}

scene::Scene with(const scene::Region& region) {
    scene::Scene s;
    s.anchor.width = 0.8;
    s.regions = {region};
    return s;
}

TEST(LoadRecorder, RowsAreMeansSinceTheRowBefore) {
    Simulation simulation(pulled(0.005));  // the plate's lower face keeps its contact
    LoadRecorder recorder(10 * 0.005 * simulation.state().settings.dt / 0.8 * 0.999, 2, 1);
    double d = 0, load = 0, leading = 0, trailing = 0, work = 0;
    int steps = 0, rows = 0;
    for (int k = 0; k < 31; ++k) {
        simulation.step();
        const graph::Body& body = simulation.state().bodies.front();
        d += simulation.d_over_B(), load += 2 * simulation.load(), ++steps;
        leading += 2 * simulation.leading(), trailing += 2 * simulation.trailing();
        work += 2 * mpm::plate_work(body.plate, body.contact.reaction, simulation.state().settings.dt);
        const auto row = recorder.after_step(simulation);
        if (!row) continue;
        EXPECT_NEAR(row->d_over_B, d / steps, 1e-15);
        EXPECT_NEAR(row->load, load / steps, 1e-9 * std::abs(load));
        EXPECT_NEAR(row->leading, leading / steps, 1e-9 * std::abs(leading));
        EXPECT_LT(row->trailing, 0);
        EXPECT_NEAR(row->trailing, trailing / steps, 1e-9 * std::abs(leading));
        EXPECT_NEAR(row->plate_work, work, 1e-12 * std::abs(work));
        EXPECT_NEAR(row->strain_work, 2 * simulation.state().stress_work, 1e-12);
        EXPECT_NEAR(row->kinetic_energy, 2 * mpm::kinetic_energy(simulation.state().points, 3), 1e-12);
        EXPECT_EQ(recorder.last(), row->load);
        d = load = leading = trailing = 0, steps = 0, ++rows;
    }
    EXPECT_GE(rows, 3);
}

// What damping took, what the transfer took and what the kinetic energy gained, over the plate's work since
// the row before, or over that of lifting the weight on it where it is more.
TEST(LoadRecorder, DragSharesAreOfTheRowsOwnWork) {
    for (const double unit_load : {1e-9, 1e9}) {
        Spec spec = pulled(0.005);
        spec.scheme.damping = 0.2, spec.scheme.pic_fraction = 0.1;
        Simulation simulation(spec);
        LoadRecorder recorder(10 * 0.005 * simulation.state().settings.dt / 0.8 * 0.999, 2, unit_load);
        io::LoadRow before;
        mpm::NodeWork nodes;
        double travel = 0;
        int rows = 0;
        for (int k = 0; k < 31; ++k) {
            simulation.step();
            const auto row = recorder.after_step(simulation);
            if (!row) continue;
            const double work =
                std::fmax(row->plate_work - before.plate_work, unit_load * (simulation.travel() - travel));
            const double kinetic = row->kinetic_energy - before.kinetic_energy;
            const mpm::NodeWork now = simulation.state().node_work;
            EXPECT_NEAR(row->damping_share, 2 * (now.damping - nodes.damping) / work, 1e-12);
            EXPECT_NEAR(row->inertia_share, kinetic / work, 1e-12);
            EXPECT_NEAR(row->pic_share, (2 * (now.gained - nodes.gained) - kinetic) / work, 1e-12);
            EXPECT_GT(row->damping_share, 0);
            before = *row, nodes = now, travel = simulation.travel(), ++rows;
        }
        EXPECT_GE(rows, 3);
    }
}

// The ground's energy over what the plate has put into it, looked at from 0.005 of its width on.
TEST(LoadRecorder, TheKineticShareIsOfThePlatesWork) {
    Simulation simulation(pulled());
    LoadRecorder recorder(1e-9, 1, 1e-9);
    double largest = 0;
    bool looked = false;
    for (int k = 0; k < 200; ++k) {
        simulation.step();
        const auto row = recorder.after_step(simulation);
        EXPECT_EQ(std::isnan(recorder.kinetic_share_max()), !looked && simulation.d_over_B() < 0.005);
        if (simulation.d_over_B() < 0.005) continue;
        looked = true;
        largest = std::max(largest, row->kinetic_energy / row->plate_work);
    }
    ASSERT_TRUE(looked);
    EXPECT_NEAR(recorder.kinetic_share_max(), largest, 1e-12);
}

// A plate that has done less than it takes to lift what lies on it: the ratio is over that work, never over
// nothing.
TEST(LoadRecorder, TheKineticShareIsOverTheWorkOfLiftingAtLeast) {
    Simulation simulation(pulled());
    constexpr double unit = 1e9;
    LoadRecorder recorder(1e-9, 1, unit);
    double largest = 0;
    for (int k = 0; k < 200; ++k) {
        simulation.step();
        const auto row = recorder.after_step(simulation);
        if (simulation.d_over_B() < 0.005) continue;
        if (row->plate_work <= 0) continue;
        largest = std::max(largest, row->kinetic_energy / (unit * simulation.travel()));
    }
    ASSERT_GT(largest, 0);
    EXPECT_NEAR(recorder.kinetic_share_max(), largest, 1e-9 * largest);
}

TEST(RegionRecorder, ARegionInPlateWidthsLiesAboutThePlate) {
    const Simulation simulation(pulled());
    const RegionRecorder recorder(with({"A", false, false, {0.5, 1}, {-0.25, 0.25}, {}}), simulation, 0.2);
    // x from 1.4 to 1.8, y from 0.8 to 1.2: four by four points.
    EXPECT_EQ(recorder.regions().at(0).points, 16);
    const io::RegionRow row = recorder.rows(simulation).at(0);
    EXPECT_NEAR(row.x.min, 1.45, 1e-12);
    EXPECT_NEAR(row.x.max, 1.75, 1e-12);
    EXPECT_NEAR(row.x.mean, 1.6, 1e-12);
    EXPECT_NEAR(row.y.min, 0.85, 1e-12);
    EXPECT_NEAR(row.y.max, 1.15, 1e-12);
}

TEST(RegionRecorder, StressesAreCompressionPositiveAndKIsThatOfTheMeans) {
    Simulation simulation(pulled());
    const RegionRecorder recorder(with({"A", false, true, {0, 0.2}, {0, 0.1}, {}}), simulation, 0.2);
    const io::RegionRow row = recorder.rows(simulation).at(0);
    EXPECT_NEAR(row.sigma_xx.mean, 1e3, 1e-9);
    EXPECT_NEAR(row.sigma_yy.mean, 2e3, 1e-9);
    EXPECT_NEAR(row.sigma_xy.mean, -300, 1e-9);
    EXPECT_NEAR(row.p.mean, 1500, 1e-9);
    EXPECT_NEAR(row.q.mean, std::hypot(500, 300), 1e-9);
    EXPECT_NEAR(row.K.mean, 0.5, 1e-12);
    for (int k = 0; k < 3; ++k) simulation.step();
    const io::RegionRow later = recorder.rows(simulation).at(0);
    EXPECT_NEAR(later.K.mean, later.sigma_xx.mean / later.sigma_yy.mean, 1e-12);
    EXPECT_EQ(later.time, simulation.time());
}

TEST(RegionRecorder, ATrackedPointIsTheNearestOne) {
    const Simulation simulation(pulled());
    const RegionRecorder recorder(with({"A", true, true, {0.36, 0.36}, {1.72, 1.72}, {}}), simulation, 0.2);
    EXPECT_EQ(recorder.regions().at(0).points, 1);
    EXPECT_NEAR(recorder.rows(simulation).at(0).x.mean, 0.35, 1e-12);
    EXPECT_NEAR(recorder.rows(simulation).at(0).y.mean, 1.75, 1e-12);
}

const io::Field& field(const io::Frame& frame, const std::string& name) {
    return *std::ranges::find(frame.fields, name, &io::Field::name);
}

TEST(MakeFrame, TensorsKeepTheirPlacesAndSigns) {
    Simulation simulation(pulled());
    for (int k = 0; k < 30; ++k) simulation.step();
    const mpm::Points& points = simulation.state().points;
    std::vector<Vec2> start(points.size(), Vec2(0.5, 0.25));
    const io::Frame frame = make_frame(simulation, start, 0.2, {});
    for (const std::size_t p : {0u, 77u, 300u}) {
        const auto of = [&](const char* name, int components, int k) {
            return field(frame, name).values[components * p + k];
        };
        EXPECT_EQ(of("displacement", 2, 0), points.x[p] - 0.5);
        EXPECT_EQ(of("displacement", 2, 1), points.y[p] - 0.25);
        EXPECT_EQ(of("F", 4, 1), points.F[p](0, 1));
        EXPECT_EQ(of("F", 4, 2), points.F[p](1, 0));
        EXPECT_NE(points.F[p](0, 1), points.F[p](1, 0));
        EXPECT_EQ(of("stress", 3, 0), -points.stress[p].xx);
        EXPECT_EQ(of("stress", 3, 1), -points.stress[p].yy);
        EXPECT_EQ(of("stress", 3, 2), -points.stress[p].xy);
        // Of a law that knows none: the solid stays, the volume grows.
        EXPECT_NEAR(of("porosity", 1, 0), 1 - 0.8 * points.volume0[p] / points.volume[p], 1e-12);
    }
    EXPECT_EQ(frame.plate_x, 1);
    EXPECT_EQ(frame.plate_y, simulation.state().bodies[0].plate.y);
    EXPECT_GT(frame.plate_y, 1);
}

TEST(FrameRecorder, TakesAFrameAtEveryMarkReachedUpToRoundOff) {
    Simulation simulation(pulled());
    scene::Scene s;
    const double step = 0.5 * simulation.state().settings.dt / 0.8;
    s.output.frames = {0, 3 * step, 3.5 * step, 6 * step + 1e-12};
    FrameRecorder recorder(s, simulation, 0.2);
    std::vector<int> at;
    for (int k = 1; k <= 8; ++k) {
        simulation.step();
        if (recorder.after_step(simulation)) at.push_back(k);
    }
    EXPECT_EQ(at, (std::vector<int>{1, 3, 4, 6}));
}

// Per step the work of the mean of its stresses before and after: exact where the stress is linear in strain.
TEST(StressWork, OfAnElasticBlockIsItsEnergy) {
    Spec spec = support::bare_spec({0, 0, 0.1, 10, 10});
    spec.ground.extent = {0.3, 0.3, 0.7, 0.7};
    spec.law = support::elastic({1e6, 0});
    spec.ground.velocity = [](double x, double) { return Vec2(0.1 * (x - 0.5), 0); };
    Simulation simulation(spec);
    for (int k = 0; k < 10; ++k) simulation.step();
    double energy = 0;
    for (std::size_t p = 0; p < simulation.state().points.size(); ++p) {
        const Stress& t = simulation.state().points.stress[p];
        energy += 0.01 * 0.5 * (t.xx * t.xx + t.yy * t.yy + 2 * t.xy * t.xy) / 1e6;
    }
    EXPECT_GT(energy, 0);
    EXPECT_NEAR(simulation.state().stress_work, energy, 2e-3 * energy);
}

}  // namespace
}  // namespace sandgraph::simulation
