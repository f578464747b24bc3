#include "simulation/make_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/bare_spec.hpp"

namespace sandgraph::simulation {
namespace {

// A block of 4 x 4 points that flies.
io::Frame flying() {
    Spec spec = support::bare_spec({0, 0, 0.1, 10, 10});
    spec.ground.extent = {0.3, 0.3, 0.7, 0.7};
    spec.law = support::elastic({1e6, 0.3});
    spec.ground.velocity = [](double, double) { return Vec2(0.1, -0.2); };
    const Simulation simulation(spec);
    const mpm::Points& points = simulation.state().points;
    std::vector<Vec2> start;
    for (std::size_t p = 0; p < points.size(); ++p) start.emplace_back(points.x[p] - 0.01, points.y[p]);
    return make_frame(simulation, start, 0.16, {});
}

const io::Field& field(const io::Frame& frame, const std::string& name) {
    return *std::ranges::find(frame.fields, name, &io::Field::name);
}

TEST(MakeFrame, TellsWhereAPointWentAndHowFastItGoes) {
    const io::Frame frame = flying();
    const io::Field &u = field(frame, "displacement"), &v = field(frame, "velocity");
    ASSERT_EQ(u.values.size(), 2 * frame.x.size());
    EXPECT_NEAR(u.values[0], 0.01, 1e-12);
    EXPECT_NEAR(u.values[1], 0, 1e-12);
    EXPECT_NEAR(v.values[0], 0.1, 1e-12);
    EXPECT_NEAR(v.values[1], -0.2, 1e-12);
    EXPECT_EQ(v.unit, "m/s");
}

TEST(MakeFrame, NamesTheComponentsOfEveryFieldThatHasSeveral) {
    for (const io::Field& field : flying().fields) {
        const auto blanks = std::ranges::count(field.component_names, ' ');
        if (field.component_names == io::plane_vector)
            EXPECT_EQ(field.components, 2) << field.name;
        else
            EXPECT_EQ(field.components, field.component_names.empty() ? 1 : blanks + 1) << field.name;
    }
    EXPECT_EQ(field(flying(), "stress").component_names, "xx yy xy");
    EXPECT_EQ(field(flying(), "F").component_names, "xx xy yx yy");
}

}  // namespace
}  // namespace sandgraph::simulation
