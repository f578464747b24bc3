#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "results/failure_pattern.hpp"
#include "results/ground_view.hpp"
#include "results/pareto_study.hpp"
#include "results/peak.hpp"
#include "results/slip_surface.hpp"

// Rules whose other side no other test looks at.
namespace sandgraph::results {
namespace {

GroundView view(bool mirror) {
    GroundView v;
    v.width = 4, v.surface = 4, v.point_size = 0.1, v.mirror = mirror;
    return v;
}

// Four rows of points over a plate whose top is at y = 2, in columns at given x, each with its own F.
io::Frame columns(const std::vector<std::pair<double, std::array<double, 4>>>& of) {
    io::Frame frame{0, 0.2, 0, 1.95, {}, {}, {}};
    io::Field F{"F", "-", 4, {}};
    for (int j = 0; j < 20; ++j)
        for (const auto& [x, f] : of) {
            frame.x.push_back(x), frame.y.push_back(2.05 + 0.1 * j);
            F.values.insert(F.values.end(), f.begin(), f.end());
        }
    frame.fields = {F};
    return frame;
}

// The band's middle dilates by 5 deg and its flanks, at 0.6 of its strain, by 20; what has 0.4 does not
// count.
TEST(ShearBandRule, ABandsPointsHaveHalfItsLargestStrain) {
    const auto sheared = [](double gamma, double psi) {
        return std::array<double, 4>{1 + gamma * std::sin(psi * std::numbers::pi / 180), 0, gamma, 1};
    };
    const io::Frame start = columns({{0.6, {1, 0, 0, 1}}, {0.7, {1, 0, 0, 1}}, {0.8, {1, 0, 0, 1}}});
    const io::Frame late =
        columns({{0.6, sheared(1e-3, 5)}, {0.7, sheared(0.62e-3, 20)}, {0.8, sheared(0.4e-3, 0)}});
    const double s5 = std::sin(5 * std::numbers::pi / 180), s20 = std::sin(20 * std::numbers::pi / 180);
    const double both = std::asin((s5 + 0.62 * s20) / (std::hypot(1, s5) + 0.62 * std::hypot(1, s20)));
    EXPECT_NEAR(shear_band(start, late, view(true)).dilation, both * 180 / std::numbers::pi, 0.1);
}

// The plate has gone from x = 1 to 1.2; the ground rises to 0.5 before where it was and sinks to 0.3 behind.
TEST(HeaveRule, OfAPlatePulledSidewaysIsMeasuredFromWhereItStarted) {
    io::Frame frame{0, 0.2, 1.2, 2, {}, {}, {}};
    io::Field u{"displacement", "m", 2, {}};
    for (int i = 0; i < 40; ++i) {
        const double x = (i + 0.5) * 0.1, rise = x > 1 && x < 1.5 ? 0.1 : x < 1 && x > 0.7 ? -0.05 : 0;
        frame.x.push_back(x), frame.y.push_back(3.95 + rise);
        u.values.insert(u.values.end(), {0, rise});
    }
    frame.fields = {u};
    const SurfaceShape shape = surface_shape(frame, view(false));
    EXPECT_NEAR(shape.heave_ahead, 0.45, 1e-9);
    EXPECT_NEAR(shape.sink_behind, 0.25, 1e-9);
    EXPECT_NEAR(shape.highest, 0.5, 1e-9);
    EXPECT_NEAR(shape.lowest, -0.25, 1e-9);
}

// A line between two columns of points, a quarter of a point from one: three quarters of its stress are that
// one's.
TEST(EdgeStress, IsInterpolatedBetweenTheColumnsBesideTheEdge) {
    io::Frame frame{0, 0, 0, 1.95, {}, {}, {}};
    io::Field stress{"stress", "Pa", 3, {}};
    for (int j = 0; j < 20; ++j)
        for (const double x : {0.425, 0.525, 0.625, 0.725}) {
            frame.x.push_back(x), frame.y.push_back(2.05 + 0.1 * j);
            const double value = x < 0.5 || x > 0.7 ? 1e9 : x < 0.6 ? 1000 : 2000;
            stress.values.insert(stress.values.end(), {value, 2 * value, -0.5 * value});
        }
    frame.fields = {stress};
    const EdgeStress e = edge_stress(frame, frame, view(true));  // at x = 0.5 + 0.05
    ASSERT_EQ(e.normal.size(), 20u);
    EXPECT_NEAR(e.normal[3], 0.75 * 1000 + 0.25 * 2000, 1e-6);
    EXPECT_NEAR(e.vertical[3], 2 * 1250, 1e-6);
    EXPECT_NEAR(e.shear[3], 0.5 * 1250, 1e-6);
}

TEST(GroundView, HasThePlateAsItLies) {
    scene::Scene s;
    s.anchor.width = 2, s.anchor.thickness = 0.3, s.anchor.embedment_ratio = 4;
    GroundView v = ground_view(s);
    EXPECT_EQ(v.plate_size_x, 2);
    EXPECT_EQ(v.plate_size_y, 0.3);
    EXPECT_TRUE(v.mirror);
    EXPECT_EQ(v.window, 12);
    s.anchor.orientation = scene::Orientation::vertical;
    v = ground_view(s);
    EXPECT_EQ(v.plate_size_x, 0.3);
    EXPECT_EQ(v.plate_size_y, 2);
    EXPECT_FALSE(v.mirror);
}

// What noise does to the slopes of the two halves is allowed for.
TEST(BreakoutRule, ASteadySlopeIsSeenThroughNoise) {
    int steady = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Random random(seed);
        std::vector<double> d, load;
        for (int k = 0; k <= 800; ++k) {
            d.push_back(0.0005 * k);
            load.push_back(2 * (1 - std::exp(-d.back() / 0.02)) + 5 * d.back() +
                           0.05 * random.uniform(-1, 1));
        }
        steady += breakout(d, load).kind == BreakoutKind::steady_slope;
    }
    EXPECT_GE(steady, 9);
}

TEST(ParetoCsv, TellsWhetherTheAuditsIntervalHoldsTheTruth) {
    ParetoRow row{"x", {}, 1, 1, 1, 0.05};
    row.against.audit_mean = 0.04, row.against.audit_ci95 = 0.02;
    EXPECT_NE(to_csv({row}).find(",yes\n"), std::string::npos);
    row.true_error = 0.07;
    EXPECT_NE(to_csv({row}).find(",no\n"), std::string::npos);
    row.true_error = std::nan("");
    EXPECT_NE(to_csv({row}).find(",\n"), std::string::npos);
}

}  // namespace
}  // namespace sandgraph::results
