#include "results/failure_pattern.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace sandgraph::results {
namespace {

constexpr double kCell = 0.1, kSurface = 4, kPlateTop = 2, kTravel = 0.2;

GroundView half_model() {
    GroundView view;
    view.width = 4, view.surface = kSurface, view.point_size = kCell, view.mirror = true;
    return view;
}

// Points of a half model over a plate at y = 1.95, with a shear strain and a rise given by place.
io::Frame ground(double d, const std::function<double(double, double)>& shear,
                 const std::function<double(double)>& rise) {
    io::Frame frame{0, d, 0, kPlateTop - 0.05, {}, {}, {}};
    io::Field u{"displacement", "m", 2, {}}, F{"F", "-", 4, {}};
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
            const double x = (i + 0.5) * kCell, y = (j + 0.5) * kCell, lift = j == 39 ? rise(x) : 0;
            frame.x.push_back(x), frame.y.push_back(y + lift);
            u.values.insert(u.values.end(), {0, lift});
            F.values.insert(F.values.end(), {1, shear(x, y), 0, 1});
        }
    frame.fields = {u, F};
    return frame;
}

double none(double, double) { return 0; }
double flat(double) { return 0; }

// A straight band of given angle to the horizontal from the plate's edge, 0.3 m thick.
std::function<double(double, double)> band(double degrees) {
    const double slope = 1 / std::tan(degrees * std::numbers::pi / 180);
    return [slope](double x, double y) {
        const double off = x - 0.5 - slope * (y - kPlateTop);
        return std::exp(-off * off / (0.15 * 0.15));
    };
}

TEST(ShearBandRule, FindsTheAngleOfAStraightBand) {
    for (const double degrees : {50.0, 70.0, 90.0, 100.0}) {
        const ShearBand found =
            shear_band(ground(0, none, flat), ground(kTravel, band(degrees), flat), half_model());
        EXPECT_NEAR(found.lower, degrees, 4) << degrees;
        EXPECT_NEAR(found.middle, degrees, 4) << degrees;
        EXPECT_NEAR(found.upper, degrees, 4) << degrees;
    }
}

TEST(ShearBandRule, SeesTheOuterEdgeBendOutwardsAtTheSurface) {
    const auto funnel = [](double x, double y) { return x < 0.6 + std::max(0.0, y - 3.5) ? 1.0 : 0.0; };
    const ShearBand found = shear_band(ground(0, none, flat), ground(kTravel, funnel, flat), half_model());
    EXPECT_NEAR(found.edge_at_surface, 45, 4);
}

TEST(ShearBandRule, OfLateStrainDoesNotSeeEarlierStrain) {
    const auto both = [](double x, double y) { return band(90)(x, y) + band(60)(x, y); };
    const ShearBand late = shear_band(ground(0.1, band(90), flat), ground(kTravel, both, flat), half_model());
    EXPECT_NEAR(late.upper, 60, 4);
}

TEST(ShearBandRule, FindsTheDilationAngleOfTheBand) {
    constexpr double psi = 14 * std::numbers::pi / 180;
    io::Frame late = ground(kTravel, none, flat);
    for (std::size_t p = 0; p < late.x.size(); ++p)
        if (std::abs(late.x[p] - 0.6) < 0.1) {  // a vertical band that shears and opens
            double* F = &late.fields[1].values[4 * p];
            F[2] = 1e-3, F[0] = 1 + 1e-3 * std::tan(psi);
        }
    EXPECT_NEAR(shear_band(ground(0, none, flat), late, half_model()).dilation, 14, 0.05);
}

TEST(ShearBandRule, TellsHowFarTheStrainedSandAboveThePlateHasTurned) {
    io::Frame late = ground(kTravel, band(90), flat);
    EXPECT_TRUE(std::isnan(band_rotation(ground(0, none, flat), half_model())));
    for (std::size_t p = 0; p < late.x.size(); ++p) {
        const bool above = late.y[p] > kPlateTop;
        const double angle = (above ? 40 : 80) * std::numbers::pi / 180, c = std::cos(angle),
                     s = std::sin(angle);
        const double stretch = late.x[p] < 1 ? 1.5 : 1;  // strained near the plate only
        double* F = &late.fields[1].values[4 * p];
        F[0] = stretch * c, F[1] = -s / stretch, F[2] = stretch * s, F[3] = c / stretch;
    }
    EXPECT_NEAR(band_rotation(late, half_model()), 40, 1e-6);
}

TEST(HeaveRule, EndsWhereTheRiseIsATenthOfTheTravel) {
    const auto cone = [](double x) { return kTravel * std::max(0.0, 1 - x / 2); };  // a tenth at x = 1.8
    const SurfaceShape shape = surface_shape(ground(kTravel, none, cone), half_model());
    EXPECT_NEAR(shape.heave_ahead, 1.8, 0.06);
    EXPECT_NEAR(shape.visible_ahead, 1.9, 0.06);  // rises 0.01 m there
    EXPECT_GT(shape.highest, 0.9);
    EXPECT_EQ(surface_shape(ground(kTravel, none, flat), half_model()).heave_ahead, 0);
}

TEST(StrainedZoneRule, IsMeasuredFromThePlate) {
    const auto block = [](double x, double y) { return x < 1.5 && std::abs(y - kPlateTop) < 1 ? 1.0 : 0.0; };
    const StrainedZone zone = strained_zone(ground(kTravel, block, flat), half_model());
    EXPECT_NEAR(zone.ahead, 1.45, 1e-9);
    EXPECT_NEAR(zone.above, 1.0, 1e-9);
    EXPECT_NEAR(zone.below, 0.9, 1e-9);
}

// Without its points below, the plate has left its track open; with them it is filled.
TEST(CavityRule, TellsAnOpenTrackFromAFilledOne) {
    io::Frame frame = ground(kTravel, none, flat);
    EXPECT_EQ(cavity_share(frame, half_model()), 0);
    for (std::size_t p = 0; p < frame.x.size(); ++p)
        if (frame.x[p] < 0.5 && frame.y[p] < 1.9) frame.y[p] -= 1;
    EXPECT_EQ(cavity_share(frame, half_model()), 1);
}

}  // namespace
}  // namespace sandgraph::results
