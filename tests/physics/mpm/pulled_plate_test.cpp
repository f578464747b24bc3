#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mpm/layout.hpp"
#include "mpm/plate.hpp"
#include "mpm/time_step.hpp"
#include "stress/mohr_coulomb.hpp"
#include "tests/support/macro_model.hpp"
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

// A plate 1 m wide in 4 m of ground at rest, 1 m above the base.
support::MacroModel ground_with_plate(const Setting& s) {
    const double height = s.depth + 1 + s.thickness, left = s.half ? 0 : -2, thick = s.thickness / 2,
                 y = 1 + thick;
    const mpm::Rectangle hole{-0.5, y - thick, 0.5, y + thick};
    support::MacroModel model(
        {left, 0, cell, s.half ? 20 : 40, static_cast<int>(std::ceil(height / cell)) + 6});
    model.points = mpm::lay_out({{left, 0, 2, height}, cell, s.per_cell, density, {hole}});
    std::vector<Stress> initial(model.points.size());
    std::vector<double> zz(model.points.size());
    for (std::size_t p = 0; p < initial.size(); ++p) {
        const double yy = -density * gravity * (height - model.points.y[p]);
        initial[p] = {s.K0 * yy, yy, 0};
        zz[p] = s.K0 * yy;
    }
    model.law = std::make_unique<stress::MohrCoulomb>(sand, initial, zz);
    const double M = model.law->p_wave_modulus(), p = density * gravity * (height - y),
                 slope = density * gravity;
    model.plate = mpm::RigidPlate{0,
                                  y,
                                  0.5,
                                  thick,
                                  {0, s.rate},
                                  std::numbers::pi / 2,
                                  mpm::contact_stiffness(1, M, cell),
                                  {p, s.K0 * p, slope, s.K0 * slope}};
    model.update.gravity = {0, -gravity};
    model.update.damping = 0.05;
    model.advance.pic = 0.01;
    model.update.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    model.set_time_step(mpm::time_step({}, {cell, M, density}));
    model.start();
    return model;
}

TEST(PlateAtRest, StaysAtRest) {
    for (const bool half : {true, false}) {
        support::MacroModel model = ground_with_plate({half, 0, 1.0, 0.6});
        const auto before = model.points.stress;
        model.steps(2000);
        double worst = 0;
        for (std::size_t p = 0; p < before.size(); ++p)
            worst = std::max({worst, std::fabs(model.points.stress[p].yy - before[p].yy),
                              std::fabs(model.points.stress[p].xy)});
        EXPECT_LT(worst, 1e-3);  // [Pa]
        EXPECT_LT(mpm::kinetic_energy(model.points), 1e-12);
        // What is left is the plate's buoyancy: rho g times its volume.
        const double share = half ? 0.5 : 1;
        EXPECT_NEAR(model.contact.reaction.total().y(), share * density * gravity * 0.1, 1e-3);
    }
}

TEST(PulledPlate, OpensACavityWithoutTension) {
    support::MacroModel model = ground_with_plate({true, 0.1, 1.0, 1, 4, 0.05});  // thinner than a cell
    const double start = model.plate->y;
    double least = 0, stretch = -1;
    while (model.plate->y - start < 0.05) {
        ASSERT_TRUE(model.step().good());
        least = std::min(least, model.contact.reaction.face(mpm::Face::bottom).y());
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(model.contact.reaction.face(mpm::Face::bottom).y(), 0);
    // Soil below the middle of the plate has let go and stays where it was: it is not drawn up through the
    // plate.
    for (std::size_t p = 0; p < model.points.size(); ++p) {
        if (model.points.x[p] > 0.2 || model.points.y[p] > start || model.points.y[p] < start - 0.15)
            continue;
        stretch = std::max(stretch, model.points.F[p](1, 1) - 1);
        EXPECT_GT(model.points.stress[p].yy, -2 * density * gravity * cell);  // its own weight
    }
    EXPECT_GT(stretch, -1);  // some point was looked at
    EXPECT_LT(stretch, 0.01);
    RecordProperty("stretch_below", std::to_string(stretch));
}

TEST(PulledPlate, HalfModelCarriesHalfTheLoad) {
    support::MacroModel half = ground_with_plate({true, 0.1, 0.6, 1, 4, 0.05});
    support::MacroModel whole = ground_with_plate({false, 0.1, 0.6, 1, 4, 0.05});
    for (int k = 0; k < 150; ++k) {
        half.step();
        whole.step();
        const double a = half.contact.reaction.total().y(), b = whole.contact.reaction.total().y();
        ASSERT_NEAR(2 * a, b, 1e-6 * std::fabs(b)) << k;
    }
}

TEST(PulledPlate, GoesOnFromACheckpointBitForBit) {
    const Setting setting{true, 0.1, 0.6, 1, 4, 0.05};
    support::MacroModel straight = ground_with_plate(setting), resumed = ground_with_plate(setting);
    straight.steps(100);
    support::MemoryArchive memory;
    const auto pass = [&](support::MacroModel& m) {
        mpm::archive(memory, m.points);
        mpm::archive(memory, m.contact);
        mpm::archive(memory, *m.plate);
        m.law->archive(memory);
    };
    pass(straight);
    memory.read_from_now_on();
    pass(resumed);
    straight.steps(100);
    resumed.steps(100);
    EXPECT_EQ(straight.points.x, resumed.points.x);
    EXPECT_EQ(straight.points.vy, resumed.points.vy);
    EXPECT_EQ(straight.points.stress, resumed.points.stress);
    EXPECT_EQ(straight.contact.slip, resumed.contact.slip);
    EXPECT_EQ(straight.contact.reaction.total(), resumed.contact.reaction.total());
}

TEST(PulledPlate, WorkAndEnergyBalance) {
    support::MacroModel model = ground_with_plate({true, 0.1, 1.0, 1});
    model.audit = true;
    const double potential = mpm::gravity_potential(model.points, model.update.gravity);
    const double start = model.plate->y;
    while (model.plate->y - start < 0.02) model.step();
    const double lifted = mpm::gravity_potential(model.points, model.update.gravity) - potential;
    const double stored = model.work + lifted + mpm::kinetic_energy(model.points);
    EXPECT_LE(stored, model.plate_work * 1.001);  // the rest went into damping
    EXPECT_GT(stored, model.plate_work * 0.9);
    RecordProperty("stored_over_plate_work", std::to_string(stored / model.plate_work));
}

}  // namespace
}  // namespace sandgraph
