#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mpm/contact.hpp"
#include "mpm/grid_update.hpp"
#include "mpm/layout.hpp"
#include "mpm/time_step.hpp"
#include "mpm/transfer.hpp"
#include "mpm/two_field.hpp"

// What the contact does on every face and to both sides of its limits.
namespace sandgraph::mpm {
namespace {

constexpr double cell = 0.1, rough = std::numbers::pi / 2, k_a = 6e8;  // [Pa/m]

struct Embedded {
    RigidPlate plate;
    Points points;
    Grid grid{GridShape{0, 0, cell, 30, 30}};
    Order order;
    Contact contact;

    explicit Embedded(bool horizontal = true, const RestPressure& rest = {30e3, 20e3, 0, 0}) {
        plate.x = 1.5, plate.y = horizontal ? 1.45 : 1.5;
        if (!horizontal) plate.x = 1.45;
        plate.half_width = horizontal ? 0.5 : 0.05, plate.half_height = horizontal ? 0.05 : 0.5;
        plate.friction_angle = 0.35, plate.stiffness = k_a, plate.rest = rest;
        points = lay_out({{0.5, 0.5, 2.5, 2.5}, cell, 1, 1800, {plate.rectangle()}});
        contact = make_contact(points.size());
    }
    void load() {
        set_bodies(grid, std::array{enrichment_of(plate)}, points.half);
        refresh(order, points, grid);
        points_to_grid(points, order, grid);
        add_contact(plate, points, order, grid, contact);
    }
    void slipped(Face face, double slip) {
        std::fill(contact.slip.begin(), contact.slip.end(), slip);
        std::fill(contact.face.begin(), contact.face.end(), static_cast<std::uint8_t>(face));
    }
    // Shear on the plate along a face that all its soil has slipped along by `slip` before.
    double shear(Face face, double slip) {
        slipped(face, slip);
        load();
        const Vec2 f = contact.reaction.face(face);
        return horizontal(face) ? f.x() : f.y();
    }
};

// Soil that slips one way drags the plate with it, by the same whichever way.
TEST(ContactLimits, CoulombsLimitHoldsForSlipOfEitherSignOnEveryFace) {
    for (const auto& [face, pressure, length] : {std::tuple{Face::top, 30e3, 1.0},
                                                 {Face::bottom, 30e3, 1.0},
                                                 {Face::left, 20e3, 0.1},
                                                 {Face::right, 20e3, 0.1}})
        for (const double sign : {-1.0, 1.0}) {
            Embedded e;
            const double limit = std::tan(0.35) * pressure * length;
            EXPECT_NEAR(e.shear(face, sign * 0.01), sign * limit, 1e-6) << int(face);
            Embedded below;
            const double slip = 0.9 * limit / (k_a * length);
            EXPECT_NEAR(below.shear(face, sign * slip), sign * 0.9 * limit, 1e-6) << int(face);
        }
}

TEST(ContactLimits, SlipPastTheLimitIsLost) {
    for (const double sign : {-1.0, 1.0}) {
        Embedded e;
        e.shear(Face::top, sign * 0.01);
        for (const ContactPoint& t : e.contact.points)
            if (t.face == Face::top) {
                EXPECT_NEAR(e.contact.slip[std::size_t(t.point)], sign * std::tan(0.35) * 30e3 / k_a, 1e-12);
            }
    }
}

// Of soil at rest against a plate that moves by (a, b): the soil slips back along each face.
TEST(ContactLimits, SlipIsTheSoilsWayAgainstThePlateAlongEachFace) {
    Embedded e;
    e.load();
    e.plate.velocity = {0.3, -0.2};
    update_grid({1e-6, {0, 0}, 0, 1, {}}, e.grid);
    advance_slip(e.plate, e.grid, 1e-3, e.contact);
    for (const ContactPoint& t : e.contact.points) {
        const Vec2 soil = velocity(e.grid, t.stencil);
        const double expected = horizontal(t.face) ? soil.x() - 0.3 : soil.y() + 0.2;
        EXPECT_NEAR(e.contact.slip[std::size_t(t.point)], 1e-3 * expected, 1e-15);
    }
    EXPECT_GT(e.contact.points.size(), 20u);
}

// At the plate's centre y = 1.5; the upper edge is half a metre higher, 10 kPa/m less.
TEST(ContactLimits, RestPressureGrowsWithDepthAlongAVerticalPlate) {
    Embedded e(false, {30e3, 20e3, 15e3, 10e3});
    e.load();
    const Reaction& r = e.contact.reaction;
    EXPECT_NEAR(r.face(Face::left).x(), 20e3, 1e-6);
    EXPECT_NEAR(r.face(Face::right).x(), -20e3, 1e-6);
    EXPECT_NEAR(r.face(Face::top).y(), -(30e3 - 0.5 * 15e3) * 0.1, 1e-6);
    EXPECT_NEAR(r.face(Face::bottom).y(), (30e3 + 0.5 * 15e3) * 0.1, 1e-6);
    for (const ContactPoint& t : e.contact.points) {
        if (horizontal(t.face)) continue;
        const double y = e.points.y[std::size_t(t.point)];
        EXPECT_NEAR(k_a * t.penetration, 20e3 + (1.5 - y) * 10e3, 1e-6);
    }
}

TEST(ContactLimits, PressureIsTheStiffnessTimesThePenetrationOfTheFaceInTheWay) {
    for (const auto& [move, face] : {std::pair{Vec2(0, 1e-4), Face::top}, {Vec2(0, -1e-4), Face::bottom}}) {
        Embedded e(true, {});
        e.plate.x += move.x(), e.plate.y += move.y();
        e.load();
        const double sign = face == Face::top ? -1 : 1;
        EXPECT_NEAR(e.contact.reaction.face(face).y(), sign * k_a * 1e-4 * 1.0, 1e-3);
    }
    for (const auto& [move, face] : {std::pair{Vec2(1e-4, 0), Face::right}, {Vec2(-1e-4, 0), Face::left}}) {
        Embedded e(false, {});
        e.plate.x += move.x(), e.plate.y += move.y();
        e.load();
        const double sign = face == Face::right ? -1 : 1;
        EXPECT_NEAR(e.contact.reaction.face(face).x(), sign * k_a * 1e-4 * 1.0, 1e-3);
    }
}

// A corner point overlaps two faces: it is pushed out the short way.
TEST(ContactLimits, ACornerPointIsInContactWithTheFaceThatItPenetratesLeast) {
    for (const auto& [move, face] :
         {std::pair{Vec2(3e-4, 1e-4), Face::top}, {Vec2(1e-4, 3e-4), Face::right}}) {
        Embedded e(true, {});
        e.plate.x += move.x(), e.plate.y += move.y();
        e.load();
        int corners = 0;
        for (const ContactPoint& t : e.contact.points) {
            const auto p = std::size_t(t.point);
            if (e.points.x[p] < 2 || e.points.y[p] < 1.5) continue;
            EXPECT_EQ(t.face, face);
            EXPECT_NEAR(t.penetration, 1e-4, 1e-12);
            EXPECT_NEAR(t.length, 3e-4, 1e-12);
            ++corners;
        }
        EXPECT_EQ(corners, 1);
    }
}

TEST(TimeStep, IsBoundedByTheContactAndScalesWithTheMedium) {
    Scheme scheme;
    const Medium m{0.1, 8e7, 2000};
    EXPECT_NEAR(crossing_time(scheme, m), 0.1 / 200, 1e-12);
    EXPECT_NEAR(time_step(scheme, m), 0.3 * 0.1 / 200, 1e-12);
    scheme.contact_stiffness = 3;
    EXPECT_NEAR(time_step(scheme, m), 0.225 * 0.1 / 200, 1e-12);
    scheme.mass_scaling = 4;
    EXPECT_NEAR(time_step(scheme, m), 2 * 0.225 * 0.1 / 200, 1e-12);
    EXPECT_NEAR(contact_stiffness(2, 8e7, 0.1), 1.6e9, 1);
}

}  // namespace
}  // namespace sandgraph::mpm
