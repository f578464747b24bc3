#include "stress/mohr_coulomb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "stress/elastic.hpp"
#include "tests/support/memory_archive.hpp"

namespace sandgraph::stress {
namespace {

constexpr double degree = std::numbers::pi / 180;
const MohrCoulombConstants sand{20e6, 0.3, 32 * degree, 5 * degree, 0};
const MohrCoulombConstants clay{20e6, 0.3, 20 * degree, 0, 10e3};

// One point driven by strain increments.
struct Element {
    MohrCoulomb law;
    std::vector<std::int32_t> ids{0};
    std::vector<Mat2> F{Mat2::Identity()};
    std::vector<Stress> stress{Stress{}};

    Element(const MohrCoulombConstants& constants, double pressure)
        : law(constants, {Stress{-pressure, -pressure, 0}}, {-pressure}) {
        law.initialise({ids, F, stress, 0});
    }
    const Stress& strain(double xx, double yy, double xy = 0) {
        F[0] << 1 + xx, xy, xy, 1 + yy;
        law.update({ids, F, stress, 1});
        return stress[0];
    }
};

// Lateral stress kept at `pressure` by Newton's iteration on its own strain, from the stress before.
void compress(Element& e, const MohrCoulombConstants& constants, double pressure, double step) {
    const Element before = e;
    const double M = ElasticConstants{constants.young, constants.poisson}.p_wave();
    double lateral = 0;
    for (int k = 0; k < 200; ++k) {
        Element trial = before;
        const double error = trial.strain(lateral, -step).xx + pressure;
        if (std::fabs(error) < 1e-9 * pressure) break;
        lateral -= error / M;
    }
    e.strain(lateral, -step);
}

// sigma_1 = sigma_3 N + 2 c sqrt(N), N = tan^2(45 + phi/2).
double strength(const MohrCoulombConstants& k, double confinement) {
    const double N = std::pow(std::tan(45 * degree + k.friction_angle / 2), 2);
    return confinement * N + 2 * k.cohesion * std::sqrt(N);
}

TEST(MohrCoulomb, CompressionAtConstantLateralStressEndsAtItsStrength) {
    for (const auto& constants : {sand, clay}) {
        Element e(constants, 50e3);
        for (int k = 0; k < 400; ++k) compress(e, constants, 50e3, 1e-4);
        EXPECT_NEAR(-e.stress[0].yy, strength(constants, 50e3), 1e-5 * strength(constants, 50e3));
    }
}

TEST(MohrCoulomb, DilatesByItsDilationAngleAtFailure) {  // plane strain: -d eps_v / d gamma = sin psi
    Element e(sand, 50e3);
    for (int k = 0; k < 400; ++k) compress(e, sand, 50e3, 1e-4);
    compress(e, sand, 50e3, 1e-4);
    const double xx = e.F[0](0, 0) - 1, yy = e.F[0](1, 1) - 1;
    EXPECT_NEAR((xx + yy) / (xx - yy), std::sin(sand.dilation_angle), 1e-3);
}

TEST(MohrCoulomb, IsElasticInside) {
    Element e(clay, 50e3);
    const Stress s = e.strain(0, -1e-5);
    const double M = ElasticConstants{clay.young, clay.poisson}.p_wave();
    EXPECT_NEAR(s.yy, -50e3 - M * 1e-5, 1e-3 * M * 1e-5);
    EXPECT_EQ(e.strain(0, 1e-5 / (1 - 1e-5)).xy, 0);
    EXPECT_NEAR(e.stress[0].yy, -50e3, 1e-3);
}

TEST(MohrCoulomb, PulledApartItStaysAtTheApex) {
    for (const auto& constants : {sand, clay}) {
        Element e(constants, 50e3);
        for (int k = 0; k < 50; ++k) e.strain(2e-3, 1e-3);
        const double apex = constants.cohesion / std::tan(constants.friction_angle);
        EXPECT_NEAR(e.stress[0].xx, apex, 1e-6);
        EXPECT_NEAR(e.stress[0].yy, apex, 1e-6);
        EXPECT_NEAR(e.law.out_of_plane(0), apex, 1e-6);
    }
}

TEST(ReturnToYield, EndsOnTheSurfaceAndKeepsTheOrder) {
    Random random(4);
    int inside = 0, outside = 0;
    for (int k = 0; k < 2000; ++k) {
        const auto& constants = k % 2 ? sand : clay;
        Principal trial{random.uniform(-2e5, 1e5), random.uniform(-2e5, 1e5), random.uniform(-2e5, 1e5)};
        std::sort(trial.rbegin(), trial.rend());
        const Principal s = return_to_yield(trial, constants);
        const bool elastic = yield(trial[0], trial[2], constants) <= 0;
        if (elastic)
            EXPECT_EQ(s, trial);
        else
            EXPECT_NEAR(yield(s[0], s[2], constants), 0, 1e-6);
        ++(elastic ? inside : outside);
        EXPECT_GE(s[0], s[1] - 1e-6);
        EXPECT_GE(s[1], s[2] - 1e-6);
    }
    EXPECT_GT(inside, 50);
    EXPECT_GT(outside, 50);
}

// Associated flow: the return is the closest point in the energy norm, so no admissible stress may be nearer.
TEST(ReturnToYield, IsTheClosestPointWhenFlowIsAssociated) {
    MohrCoulombConstants associated = clay;
    associated.dilation_angle = associated.friction_angle;
    const double nu = associated.poisson;
    const auto distance = [nu](const Principal& a, const Principal& b) {
        const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
        return x * x + y * y + z * z - 2 * nu * (x * y + y * z + z * x);
    };
    Random random(8);
    for (int k = 0; k < 300; ++k) {
        Principal trial{random.uniform(-2e5, 1e5), random.uniform(-2e5, 1e5), random.uniform(-2e5, 1e5)};
        std::sort(trial.rbegin(), trial.rend());
        const Principal s = return_to_yield(trial, associated);
        for (int probe = 0; probe < 200; ++probe) {
            const double size = probe % 2 ? 1e3 : 2e4;
            Principal other = s;
            for (double& v : other) v += random.uniform(-size, size);
            std::sort(other.rbegin(), other.rend());
            if (yield(other[0], other[2], associated) > 0) continue;
            EXPECT_GE(distance(trial, other), distance(trial, s) - 1e-6 * distance(trial, {0, 0, 0}));
        }
    }
}

TEST(MohrCoulomb, RestartsWithItsOutOfPlaneStress) {
    Element e(sand, 50e3), fresh(sand, 50e3);
    for (int k = 0; k < 30; ++k) e.strain(1e-4, -3e-4, 2e-4);
    support::MemoryArchive memory;
    e.law.archive(memory);
    memory.read_from_now_on();
    fresh.law.archive(memory);
    fresh.stress = e.stress;
    EXPECT_EQ(e.strain(1e-4, -3e-4), fresh.strain(1e-4, -3e-4));
    EXPECT_EQ(e.law.out_of_plane(0), fresh.law.out_of_plane(0));
}

}  // namespace
}  // namespace sandgraph::stress
