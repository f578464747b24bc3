#include <array>

#include "stability/rve_sample.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

constexpr double kLargest = 0.5;  // Hencky strain of one update that an RVE takes (dem/rve.cpp)

// Biaxial, isochoric: ln F_xx = strain, in increments of `size`; q and p at the end.
struct Answer {
    double p, q;
};
Answer sheared(RveSample& sample, double strain, double size) {
    for (int k = 0; k < std::lround(strain / size); ++k)
        sample.drive(increment(std::exp(size) - 1, 0, 0, std::exp(-size) - 1));
    return {sample.p(), sample.q()};
}

void refused(Effort, Findings& found) {
    RveSample sample;
    found.driven = "increments 10 times the largest one allowed (Hencky strain 5 instead of 0.5)";
    sheared(sample, 2e-3, 1e-4);
    const Mat2 before = sample.rve.stress();
    const auto position = sample.rve.packing().position;
    const double e = 10 * kLargest, s = std::sqrt(0.5);
    int refusals = 0;
    for (const Mat2& F : {increment(std::exp(e * s) - 1, 0, 0, std::exp(-e * s) - 1),
                          increment(std::exp(-e * s) - 1, 0, 0, std::exp(-e * s) - 1),
                          increment(std::exp(e * s) - 1, 0, 0, std::exp(e * s) - 1),
                          increment(0, 2 * e, 0, 0), increment(-2, 0, 0, 0)})
        refusals += sample.drive(F).status == dem::RveStatus::bad_increment;
    found.exactly("refused, of 5", refusals, 5);
    found.exactly("state changed", sample.rve.packing().position != position || sample.rve.stress() != before,
                  0);
    sample.failures = 0;
    sheared(sample, 2e-3, 1e-4);
    found.exactly("updates that failed afterwards", static_cast<double>(sample.failures), 0);
    found.at_least("p grows on along the path, factor", sample.p() / (0.5 * before.trace()), 1.02);
}

void tenfold(Effort, Findings& found) {
    RveSample fine, coarse, rash;
    found.driven = "isochoric biaxial to 2 %: increments of 1e-3 for 1e-4; then DEM steps of 1e-4 for 1e-5";
    const Answer a = sheared(fine, 0.02, 1e-4), b = sheared(coarse, 0.02, 1e-3);
    rash.options.strain_per_step_max *= 10, rash.options.inertial_number_max *= 10;
    const Answer c = sheared(rash, 0.02, 1e-4);
    found.within("p, increments 10 times", b.p / a.p, 0.9, 1.1);
    found.within("q/p, increments 10 times", (b.q / b.p) / (a.q / a.p), 0.9, 1.1);
    found.within("p, strain a DEM step 10 times", c.p / a.p, 0.8, 1.25);
    found.within("q/p, strain a DEM step 10 times", (c.q / c.p) / (a.q / a.p), 0.8, 1.25);
    found.exactly("updates that failed", static_cast<double>(fine.failures + coarse.failures + rash.failures),
                  0);
}

// The largest increments that are let through.
void largest(Effort effort, Findings& found) {
    RveSample sample;
    if (effort == Effort::quick) sample.options.strain_per_step_max = 1e-4;
    if (effort == Effort::quick) sample.options.inertial_number_max = 1e-2;
    found.driven = "ten increments of Hencky strain 0.49, there and back";
    for (int k = 0; k < 10; ++k) {
        const double e = (k % 2 ? -1 : 1) * 0.49 * std::sqrt(0.5);
        sample.drive(increment(std::exp(e) - 1, 0, 0, std::exp(-e) - 1));
    }
    found.exactly("updates that failed", static_cast<double>(sample.failures), 0);
    found.at_most("/J - 1/", std::fabs(sample.rve.volume_ratio() - 1), 1e-9);
    found.within("q/p", sample.q() / sample.p(), 0.15, 0.6);
}

constexpr std::array table = {Case{"rve.increments.refused", refused},
                              Case{"rve.increments.tenfold", tenfold},
                              Case{"rve.increments.largest", largest}};

}  // namespace

std::span<const Case> rve_increment_cases() { return table; }

}  // namespace sandgraph::stability
