#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/bare_spec.hpp"

// What damping and PIC take from a wave in a given time does not depend on the time step.
namespace sandgraph {
namespace {

constexpr double L = 25, young = 100, density = 1;
constexpr int cells = 50;

// A standing wave of eight cells in a bar fixed at x = 0 and free at L.
simulation::Spec bar(double courant, double damping, double pic) {
    const double cell = L / cells;
    simulation::Spec spec = support::bare_spec({0, 0, cell, cells + 2, 1});
    spec.ground.extent = {0, 0, L, cell};
    spec.ground.density = density;
    spec.ground.velocity = [](double x, double) {
        return Vec2(0.01 * std::sin(12.5 * std::numbers::pi * x / L), 0);
    };
    spec.law = support::elastic({young, 0});
    spec.boundaries = {mpm::Side::fixed, mpm::Side::free, mpm::Side::mirror, mpm::Side::mirror};
    spec.scheme.courant = courant, spec.scheme.damping = damping, spec.scheme.pic_fraction = pic;
    return spec;
}

// -ln of the share of the energy that is left after 4 s, ten periods.
double loss(double courant, double damping, double pic) {
    simulation::Simulation model(bar(courant, damping, pic));
    const double before = mpm::kinetic_energy(model.state().points);
    while (model.time() < 4) model.step();
    return -std::log((mpm::kinetic_energy(model.state().points) + model.state().stress_work) / before);
}

// Of damping or PIC alone: the transfer has a loss of its own, which falls with the step; the two are not
// quite additive (11 % from 0.3 to 0.03 of courant).
double part(double courant, double damping, double pic) {
    return loss(courant, damping, pic) - loss(courant, 0, 0);
}

// As a share a step PIC would take 3 and 10 times as much.
TEST(Dissipation, OfPicDoesNotGrowWithTheNumberOfSteps) {
    const double usual = part(0.3, 0, 0.05);
    EXPECT_GT(usual, 0.5);
    for (const double courant : {0.1, 0.03}) {
        EXPECT_NEAR(part(courant, 0, 0.05), usual, 0.15 * usual) << courant;
        EXPECT_LT(loss(courant, 0, 0.05), loss(0.3, 0, 0.05)) << courant;
    }
}

TEST(Dissipation, OfLocalDampingDoesNotGrowWithTheNumberOfSteps) {
    const double usual = part(0.3, 0.05, 0);
    EXPECT_GT(usual, 0.5);
    for (const double courant : {0.1, 0.03}) {
        EXPECT_NEAR(part(courant, 0.05, 0), usual, 0.15 * usual) << courant;
        EXPECT_LT(loss(courant, 0.05, 0), loss(0.3, 0.05, 0)) << courant;
    }
}

TEST(PicShare, IsTheKeysOwnInAUsualStepAndCompoundsToItInShorterOnes) {
    mpm::Scheme scheme;
    scheme.pic_fraction = 0.2, scheme.mass_scaling = 3;
    const mpm::Medium medium{0.1, 6e7, 2000};
    const double usual = 0.3 * mpm::crossing_time(scheme, medium);
    EXPECT_EQ(mpm::pic_share(scheme, medium, usual), 0.2);
    EXPECT_NEAR(std::pow(1 - mpm::pic_share(scheme, medium, usual / 7), 7), 0.8, 1e-14);
    scheme.pic_fraction = 0;
    EXPECT_EQ(mpm::pic_share(scheme, medium, usual / 7), 0);
}

}  // namespace
}  // namespace sandgraph
