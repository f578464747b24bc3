#include "results/slip_surface.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace sandgraph::results {
namespace {

constexpr double kCell = 0.1, kSurface = 4, kPlateTop = 2, kWeight = 2e4;
constexpr int kAcross = 20, kUp = 40;

GroundView half_model() {
    GroundView view;
    view.width = kAcross * kCell, view.surface = kSurface, view.point_size = kCell, view.mirror = true;
    return view;
}

// Ground of unit weight kWeight over a plate at y = 1.95: horizontal stress K times the weight above, shear
// stress on vertical planes `friction(y)` times that.
io::Frame ground(double K, const std::function<double(double)>& friction) {
    io::Frame frame{0, 0, 0, kPlateTop - 0.05, {}, {}, {}};
    io::Field stress{"stress", "Pa", 3, {}};
    for (int i = 0; i < kAcross; ++i)
        for (int j = 0; j < kUp; ++j) {
            const double y = (j + 0.5) * kCell, vertical = kWeight * (kSurface - y);
            frame.x.push_back((i + 0.5) * kCell), frame.y.push_back(y);
            stress.values.insert(stress.values.end(), {K * vertical, vertical, -friction(y) * K * vertical});
        }
    frame.fields = {stress};
    return frame;
}

std::function<double(double)> uniform(double friction) {
    return [friction](double) { return friction; };
}

std::vector<SlipSurface> seen(const std::vector<io::Frame>& frames) {
    std::vector<EdgeStress> edges;
    for (const io::Frame& frame : frames) edges.push_back(edge_stress(frames.front(), frame, half_model()));
    return slip_surfaces(edges);
}

TEST(SlipSurfaceRule, FindsTheEarthPressureAndTheFrictionOfAUniformColumn) {
    const SlipSurface s = seen({ground(1, uniform(0)), ground(0.95, uniform(0.5))}).front();
    EXPECT_NEAR(s.K, 0.95, 1e-12);
    EXPECT_NEAR(s.friction, 0.5, 1e-12);
    EXPECT_NEAR(s.greatest, 0.5, 1e-12);
    EXPECT_EQ(s.before, 0);
    EXPECT_EQ(s.past, 0);
}

TEST(SlipSurfaceRule, SeesAPeakThatTravelsUpTheColumn) {
    const auto low_first = [](double y) { return y < 3 ? 0.6 : 0.3; };
    const auto high_later = [](double y) { return y < 3 ? 0.3 : 0.6; };
    const auto s = seen({ground(1, uniform(0)), ground(1, low_first), ground(1, high_later)});
    // Of the normal stress 3/4 lie in the lower half.
    EXPECT_NEAR(s[0].before, 0.25, 1e-9);
    EXPECT_EQ(s[0].past, 0);
    EXPECT_NEAR(s[1].past, 0.75, 1e-9);
    EXPECT_NEAR(s[0].friction, 0.75 * 0.6 + 0.25 * 0.3, 1e-9);
    EXPECT_NEAR(s[0].greatest, 0.6, 1e-9);
    EXPECT_NEAR(s[1].greatest, 0.6, 1e-9);
}

TEST(SlipSurfaceRule, LeavesOutTheRowsThatThePlateHasPassed) {
    io::Frame late = ground(1, [](double y) { return y < 2.3 ? 0.0 : 0.5; });
    late.plate_y += 0.3;
    EXPECT_NEAR(seen({ground(1, uniform(0)), late}).front().friction, 0.5, 1e-12);
}

}  // namespace
}  // namespace sandgraph::results
