#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dem/stretch.hpp"
#include "laboratory/probe_path.hpp"

namespace sandgraph::laboratory {
namespace {

constexpr double kPressure = 1e4, kLength = 0.1;

// Even increments along the legs.
ProbePath path_of(std::vector<ProbeLeg> legs, double increment = 1e-4) {
    ProbePath path;
    path.legs = std::move(legs);
    path.increment = increment, path.updates = 100'000;
    return path;
}

ProbeWalk walk_of(const ProbePath& path) { return {path, kPressure, kPressure, 1}; }

TEST(ProbeWalk, TurnsThePointByTheSpinOfTheLeg) {
    ProbeWalk walk = walk_of(path_of({{.length = kLength, .volume = VolumeControl::held, .spin = 0.3}}));
    double turned = 0;
    while (!walk.done()) turned += dem::polar(walk.next(kPressure)).angle;
    EXPECT_NEAR(turned, 0.3, 1e-3);
}

// As much noise as path: half of an increment is regular, and noise averages out.
TEST(ProbeWalk, NoiseTakesItsShareOfTheIncrement) {
    ProbePath path = path_of({{.length = kLength, .volume = VolumeControl::held}});
    path.noise = 1;
    ProbeWalk walk = walk_of(path);
    double sheared = 0;
    while (!walk.done()) {
        const Mat2 U = dem::polar(walk.next(kPressure)).U;
        sheared += (U(0, 0) - U(1, 1)) / std::numbers::sqrt2;
    }
    EXPECT_NEAR(sheared / kLength, 0.5, 0.05);
}

// A leg begins at the pressure that the one before has reached: who is there need not be compressed.
TEST(ProbeWalk, LeadsThePressureFromWhereTheLegBeforeEnded) {
    const ProbeLeg to_twice{.length = kLength, .volume = VolumeControl::pressure, .pressure = 2};
    ProbeWalk walk = walk_of(path_of({to_twice, to_twice}, kLength));
    EXPECT_NEAR(walk.next(kPressure).trace(), 2, 1e-12);
    ASSERT_FALSE(walk.done());
    EXPECT_NEAR(walk.next(2 * kPressure).trace(), 2, 1e-12);
    EXPECT_TRUE(walk.done());
}

}  // namespace
}  // namespace sandgraph::laboratory
