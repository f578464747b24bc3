#include "mpm/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mpm/boundary.hpp"
#include "mpm/layout.hpp"
#include "mpm/transfer.hpp"
#include "mpm/two_field.hpp"
#include "tests/support/memory_archive.hpp"

namespace sandgraph::mpm {
namespace {

constexpr double cell = 0.1, rough = std::numbers::pi / 2;

// A plate in a block of ground under uniform stress, laid so that neither fits the grid's lines.
struct Embedded {
    double phase_x, phase_y;
    Stress stress{-40e3, -70e3, 0};
    RigidPlate plate;
    Points points;
    Grid grid{GridShape{0, 0, cell, 40, 40}};
    Order order;
    Contact contact;

    Embedded(double px, double py, bool horizontal = true, int per_cell = 1) : phase_x(px), phase_y(py) {
        const double x0 = 0.5 + px * cell, y0 = 0.5 + py * cell;
        plate.x = x0 + 1.5, plate.y = y0 + 1.05 + (horizontal ? 0 : 0.45);
        plate.x += horizontal ? 0 : 0.05;
        plate.half_width = horizontal ? 0.5 : 0.05, plate.half_height = horizontal ? 0.05 : 0.5;
        plate.friction_angle = rough, plate.stiffness = contact_stiffness(1, 60e6, cell);
        plate.rest = {-stress.yy, -stress.xx, 0, 0};
        points = lay_out({{x0, y0, x0 + 3, y0 + 2.5}, cell, per_cell, 1800, {plate.rectangle()}});
        std::fill(points.stress.begin(), points.stress.end(), stress);
        contact = make_contact(points.size());
    }

    void load() {
        set_bodies(grid, std::array{enrichment_of(plate)}, points.half);
        refresh(order, points, grid);
        points_to_grid(points, order, grid);
        add_contact(plate, points, order, grid, contact);
    }

    // Largest force on a node of either field that does not see the block's outer sides.
    double worst_force() const {
        double worst = 0;
        const Rectangle inside = {phase_x * cell + 0.7, phase_y * cell + 0.7, phase_x * cell + 3.3,
                                  phase_y * cell + 2.8};
        for (const Field& f : grid.fields)
            for (int j = f.box.j0; j <= f.box.j1; ++j)
                for (int i = f.box.i0; i <= f.box.i1; ++i) {
                    if (!inside.contains(grid.shape.x(i), grid.shape.y(j))) continue;
                    const Node& n = f.nodes[grid.shape.index(i, j)];
                    worst = std::max({worst, std::fabs(n.fx), std::fabs(n.fy)});
                }
        return worst;
    }
};

TEST(Contact, UniformStressIsInExactEquilibriumWithThePlateAtAnyPhaseOfTheGrid) {
    for (const bool horizontal : {true, false})
        for (const int per_cell : {1, 4})
            for (const double px : {0.0, 0.13, 0.5, 0.77})
                for (const double py : {0.0, 0.31, 0.5, 0.999}) {
                    Embedded e(px, py, horizontal, per_cell);
                    e.load();
                    EXPECT_LT(e.worst_force(), 1e-11 * 70e3 * cell) << px << " " << py << " " << per_cell;
                }
}

// A point that has sunk past the end of the top face and comes to lie nearer to the side is as deep under
// that: pressed out at once it would fly off.
TEST(Contact, APointThatTurnsRoundAnEndIsNotThrownOut) {
    Embedded e(0, 0.5);
    e.load();
    ASSERT_FALSE(e.contact.points.empty());
    const Rectangle body = e.plate.rectangle();
    const auto p = static_cast<std::size_t>(e.contact.points.front().point);
    const double half = e.points.half;
    e.contact.face[p] = static_cast<std::uint8_t>(Face::top);
    e.points.x[p] = body.x1 + half - 0.3 * cell, e.points.y[p] = body.y1 + half - 0.4 * cell;
    e.order.stale = true;
    const double before = e.contact.reaction.face(Face::right).norm();
    e.load();
    EXPECT_EQ(e.contact.face[p], static_cast<std::uint8_t>(Face::right));
    EXPECT_GT(e.contact.sunk[p], 0.29 * cell);
    const double thrown = e.plate.stiffness * 0.3 * cell * cell;  // a third of a cell's pressure
    EXPECT_LT(e.contact.reaction.face(Face::right).norm() - before, 0.01 * thrown);
}

TEST(Contact, LoadsExactlyThePlatesWidth) {
    Embedded e(0.37, 0.21);
    for (double& x : e.points.x) x += 0.043;  // points now straddle the plate's ends
    e.load();
    double top = 0, bottom = 0;
    for (const ContactPoint& t : e.contact.points) {
        if (t.face == Face::top) top += t.length;
        if (t.face == Face::bottom) bottom += t.length;
    }
    EXPECT_NEAR(top, 1, 1e-12);
    EXPECT_NEAR(bottom, 1, 1e-12);
}

TEST(Contact, ReactionPerFaceIsTheRestPressureTimesTheFace) {
    Embedded e(0.37, 0.21);
    e.load();
    const Reaction& r = e.contact.reaction;
    EXPECT_NEAR(r.face(Face::top).y(), -70e3 * 1.0, 1e-6);
    EXPECT_NEAR(r.face(Face::bottom).y(), 70e3 * 1.0, 1e-6);
    EXPECT_NEAR(r.face(Face::left).x(), 40e3 * 0.1, 1e-6);
    EXPECT_NEAR(r.face(Face::right).x(), -40e3 * 0.1, 1e-6);
    EXPECT_NEAR(r.total().norm(), 0, 1e-6);
}

TEST(Contact, ForcesOnTheSoilAndOnThePlateCancel) {
    Embedded e(0.37, 0.21);
    e.plate.y += 2e-3, e.plate.x += 1e-3;
    for (double& slip : e.contact.slip) slip = 1e-3;
    std::fill(e.contact.face.begin(), e.contact.face.end(), static_cast<std::uint8_t>(Face::top));
    e.load();
    Vec2 sum = Vec2::Zero();  // internal forces have no resultant
    for (const Field& f : e.grid.fields)
        for (const Node& n : f.nodes) sum += Vec2(n.fx, n.fy);
    EXPECT_GT(e.contact.reaction.total().norm(), 1e4);
    EXPECT_LT((sum + e.contact.reaction.total()).norm(), 1e-12 * e.contact.reaction.total().norm() + 1e-7);
}

TEST(Contact, TakesEdgesThatMeetToRoundOffForNoOverlap) {
    for (const double shift : {-1e-16, 1e-16, 1e-12}) {
        Embedded e(0, 0);
        e.plate.x += shift, e.plate.y += shift;
        e.load();
        EXPECT_LT(e.worst_force(), 1e-8 * 70e3 * cell);  // NaN is not less
        for (const ContactPoint& t : e.contact.points) EXPECT_GT(t.length, 1e-10);
    }
}

TEST(Contact, NeverPulls) {
    Embedded e(0.37, 0.21);
    e.plate.y += 0.02;  // a cavity of two centimetres below
    e.load();
    EXPECT_EQ(e.contact.reaction.face(Face::bottom), Vec2::Zero());
    EXPECT_LT(e.contact.reaction.face(Face::top).y(), -70e3);
    for (const ContactPoint& t : e.contact.points) EXPECT_GT(t.penetration, 0);
}

TEST(Contact, ShearStopsAtCoulombsLimitUnlessThePlateIsRough) {
    for (const double angle : {0.0, 0.3, rough}) {
        Embedded e(0.1, 0.2);
        e.plate.friction_angle = angle;
        std::fill(e.contact.slip.begin(), e.contact.slip.end(), 0.01);
        std::fill(e.contact.face.begin(), e.contact.face.end(), static_cast<std::uint8_t>(Face::top));
        e.load();
        const Vec2 on_top = e.contact.reaction.face(Face::top);
        const double expected = std::min(std::tan(angle) * 70e3, e.plate.stiffness * 0.01);
        EXPECT_NEAR(on_top.x(), expected, 1e-6 * std::max(1.0, expected));
    }
}

TEST(Contact, ForgetsItsSlipWhenContactIsLost) {
    Embedded e(0.1, 0.2);
    e.load();
    const auto below = [&] {
        return std::ranges::count_if(e.contact.points,
                                     [](const ContactPoint& t) { return t.face == Face::bottom; });
    };
    const auto before = below();
    ASSERT_GT(before, 0);
    for (const ContactPoint& t : e.contact.points) e.contact.slip[static_cast<std::size_t>(t.point)] = 1e-4;
    e.plate.y += 0.01;
    e.load();
    EXPECT_EQ(below(), 0);
    for (std::size_t p = 0; p < e.points.size(); ++p)
        EXPECT_TRUE(e.contact.face[p] != 0 || e.contact.slip[p] == 0) << p;
    e.plate.y -= 0.01;
    e.load();
    EXPECT_EQ(below(), before);
    for (const ContactPoint& t : e.contact.points)
        EXPECT_TRUE(t.face != Face::bottom || e.contact.slip[static_cast<std::size_t>(t.point)] == 0)
            << t.point;
}

TEST(TwoFields, SoilAboveDoesNotMoveTheNodesOfTheSoilBelow) {
    Embedded e(0.37, 0.21);
    for (std::size_t p = 0; p < e.points.size(); ++p) e.points.vy[p] = e.points.y[p] > e.plate.y ? 1 : 0;
    set_bodies(e.grid, std::array{enrichment_of(e.plate)}, e.points.half);
    refresh(e.order, e.points, e.grid);
    points_to_grid(e.points, e.order, e.grid);
    const int i = static_cast<int>(std::lround(e.plate.x / cell));
    int shared = 0;
    for (int j = 10; j < 25; ++j) {
        const std::size_t n = e.grid.shape.index(i, j);
        for (const Field& f : e.grid.fields) {
            const Node& node = f.nodes[n];
            if (node.mass == 0) continue;
            const double v = node.py / node.mass;
            EXPECT_TRUE(std::fabs(v) < 1e-12 || std::fabs(v - 1) < 1e-12) << v;
        }
        shared += e.grid.fields[0].nodes[n].mass > 0 && e.grid.fields[1].nodes[n].mass > 0;
    }
    EXPECT_GE(shared, 1);
}

TEST(ContactArchive, BringsHistoryAndPlateBack) {
    Embedded e(0.1, 0.2);
    e.load();
    e.contact.slip[7] = 0.125;
    e.plate.velocity = {0.5, 0.25};
    support::MemoryArchive memory;
    archive(memory, e.contact);
    archive(memory, e.plate);
    Contact contact = make_contact(e.contact.slip.size());
    RigidPlate plate;
    memory.read_from_now_on();
    archive(memory, contact);
    archive(memory, plate);
    EXPECT_EQ(contact.slip, e.contact.slip);
    EXPECT_EQ(contact.face, e.contact.face);
    EXPECT_EQ(plate.y, e.plate.y);
    EXPECT_EQ(plate.velocity, e.plate.velocity);
    EXPECT_EQ(plate.rest.horizontal, e.plate.rest.horizontal);
}

TEST(ContactArchive, RefusesOtherPointsAndUnknownFaces) {
    Contact three = make_contact(3), four = make_contact(4), odd = make_contact(3);
    odd.face[1] = kFaces;
    const auto read_into = [](Contact from, Contact into) {
        support::MemoryArchive memory;
        archive(memory, from);
        memory.read_from_now_on();
        archive(memory, into);
    };
    EXPECT_NO_THROW(read_into(three, three));
    EXPECT_THROW(read_into(four, three), StateError);
    EXPECT_THROW(read_into(odd, three), StateError);
}

}  // namespace
}  // namespace sandgraph::mpm
