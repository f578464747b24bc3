#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "base/random.hpp"
#include "stability/rve_sample.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

constexpr std::size_t kBlocks = 10;

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares(std::span<const double> values) {
    const double mean = mean_of(values);
    return std::accumulate(values.begin(), values.end(), 0.0,
                           [&](double sum, double v) { return sum + (v - mean) * (v - mean); });
}

// Of two samples of the same size.
double student(std::span<const double> a, std::span<const double> b) {
    const auto n = static_cast<double>(a.size());
    return (mean_of(b) - mean_of(a)) / std::sqrt((squares(a) + squares(b)) / (n - 1) / n);
}

// Simple shear to gamma = 10 at constant area; the late stress is that of the critical state.
void shear(Effort effort, Findings& found, const std::string& density) {
    RveSample sample(density);
    const double gamma = 2e-3;
    if (effort == Effort::quick)
        sample.options.inertial_number_max = 1e-2, sample.options.strain_per_step_max = 1e-4;
    found.driven = density + " packing, simple shear to 1000 % at constant area";
    std::array<double, kBlocks> p{};  // means over tenths of the late half: loose sand is afloat at times
    double q = 0;
    for (int k = 0; k < 5000; ++k) {
        sample.drive(increment(0, gamma, 0, 0));
        if (k >= 2500) p[(k - 2500) / 250] += sample.p() / 250, q += sample.q() / 2500;
    }
    found.exactly("updates that failed", static_cast<double>(sample.failures), 0);
    found.within("mean q over mean p of the late half", q / mean_of(p), 0.28, 0.42);
    const std::span third(p.begin(), kBlocks / 2), last(p.begin() + kBlocks / 2, kBlocks / 2);
    found.note("mean p of the last quarter over that of the third", mean_of(last) / mean_of(third));
    found.within("Student's t of the two quarters' means, five blocks each", student(third, last), -4.5, 4.5);
    found.because("the critical state is stationary; 99.8 % of samples of one mean lie within");
    found.at_most("/J - 1/", std::fabs(sample.rve.volume_ratio() - 1), 1e-9);
}

// Isotropic strain in small increments until p passes the target.
void compress_to(RveSample& sample, double target, double size) {
    const double sign = target > sample.p() ? -1 : 1;
    for (int k = 0; k < 400'000 && sign * (sample.p() - target) > 0; ++k) {
        const double e = sign * size * std::sqrt(std::max(sample.p(), 1e3) / 32e3);
        sample.drive(increment(e, 0, 0, e));
    }
}

void compression(Effort effort, Findings& found) {
    RveSample sample;
    const int cycles = effort == Effort::quick ? 1 : 10;
    found.driven = fmt::format("isotropic compression to 1 MPa and back to 0.5 kPa, {} times", cycles);
    double highest = 0, lowest = 1e9, skew = 0;
    std::vector<double> volumes;
    for (int cycle = 0; cycle < cycles; ++cycle) {
        compress_to(sample, 1e6, 2e-5);
        highest = std::max(highest, sample.p()), skew = std::max(skew, sample.q() / sample.p());
        compress_to(sample, 0.5e3, 2e-5);
        lowest = std::min(lowest, sample.p());
        volumes.push_back(sample.rve.volume_ratio());
    }
    found.exactly("updates that failed", static_cast<double>(sample.failures), 0);
    found.within("largest p [kPa]", highest / 1e3, 1000, 1010);
    found.within("smallest p [kPa]", lowest / 1e3, 0, 0.5);
    found.at_most("q/p at 1 MPa", skew, 0.1);
    found.within("J at 0.5 kPa after the last cycle", volumes.back(), 0.97, 1.01);
    found.at_most("change of J over the last cycle",
                  cycles < 2 ? 0 : std::fabs(volumes.back() - volumes[volumes.size() - 2]), 2e-3);
}

void opening(Effort effort, Findings& found) {
    RveSample sample;
    const int cycles = effort == Effort::quick ? 20 : 100;
    found.driven = fmt::format("extension by 6 %, float, recontact, {} times", cycles);
    const Mat2 open = increment(0, 0, 0, 4e-4);
    long steps_afloat = 0, floated = 0, recontacts = 0;
    for (int cycle = 0; cycle < cycles; ++cycle) {
        for (const bool opens : {true, false}) {
            for (int k = 0; k < 150; ++k) {
                const bool afloat = sample.rve.floating();
                const int steps = sample.drive(opens ? open : Mat2(open.inverse())).dem_steps;
                if (afloat && sample.rve.floating()) steps_afloat += steps;
            }
            if (opens) floated += sample.rve.floating() && sample.rve.stress() == Mat2::Zero();
            if (!opens) recontacts += sample.p() > 1e3;
        }
    }
    found.exactly("updates that failed", static_cast<double>(sample.failures), 0);
    found.exactly("openings that floated with zero stress", static_cast<double>(floated), cycles);
    found.exactly("closings that carried more than 1 kPa", static_cast<double>(recontacts), cycles);
    found.exactly("DEM steps paid afloat", static_cast<double>(steps_afloat), 0);
    found.at_most("/J - 1/ at the end", std::fabs(sample.rve.volume_ratio() - 1), 1e-9);
    found.within("p at the end [kPa]", sample.p() / 1e3, 2, 64);
}

void random_increments(Effort, Findings& found) {
    RveSample sample;
    found.driven = "10,000 random increments up to 1e-4, with spin";
    Random random(1);
    double J = 1, worst_ratio = 0, least_p = 1e9, most_p = 0;
    for (int k = 0; k < 10'000; ++k) {
        Mat2 F = Mat2::Identity();
        for (int c = 0; c < 4; ++c) F(c / 2, c % 2) += random.uniform(-1e-4, 1e-4);
        F *= 1 - 0.05 * (sample.rve.volume_ratio() - 1);  // held near its volume
        sample.drive(F);
        J *= F.determinant();
        least_p = std::min(least_p, sample.p()), most_p = std::max(most_p, sample.p());
        if (sample.p() > 1e3) worst_ratio = std::max(worst_ratio, sample.q() / sample.p());
    }
    found.exactly("updates that failed", static_cast<double>(sample.failures), 0);
    found.at_most("/J - product of det F/", std::fabs(sample.rve.volume_ratio() / J - 1), 1e-9);
    found.at_least("smallest p [kPa]", least_p / 1e3, 0);
    found.at_most("largest p [kPa]", most_p / 1e3, 500);
    found.at_most("largest q/p above 1 kPa", worst_ratio, 0.8);
}

void turns(Effort, Findings& found) {
    RveSample sample, still;
    found.driven = "100 turns of 5 degrees each, then 100 turns while sheared by 0.2 %";
    for (int k = 0; k < 5; ++k) sample.drive(increment(2e-4, 1e-4, 0, -2e-4));
    const Mat2 before = sample.rve.stress();
    const long steps = sample.dem_steps;
    for (int k = 0; k < 7200; ++k) sample.drive(dem::rotation(std::numbers::pi / 36));
    found.at_most("change of stress", (sample.rve.stress() - before).norm() / before.norm(), 1e-9);
    found.exactly("DEM steps paid for turning", static_cast<double>(sample.dem_steps - steps), 0);
    RveSample turning;
    double angle = 0;
    const Mat2 F = increment(1e-4, 0.5e-4, 0.5e-4, -1e-4);
    for (int k = 0; k < 20; ++k) {
        still.drive(F);
        for (int turn = 0; turn < 5; ++turn) {
            turning.drive(dem::rotation(2 * std::numbers::pi));  // rounded, so not quite none
            turning.drive(dem::rotation(0.3));
            angle += 0.3;
        }
        turning.drive(dem::turned(F, angle));
    }
    found.at_most(
        "stress against that of the packing which did not turn",
        (turning.rve.stress() - dem::turned(still.rve.stress(), angle)).norm() / still.rve.stress().norm(),
        1e-3);
    found.exactly("updates that failed", static_cast<double>(sample.failures + turning.failures), 0);
}

constexpr std::array table = {
    Case{"rve.shear.dense", [](Effort e, Findings& f) { shear(e, f, "dense"); }},
    Case{"rve.shear.loose", [](Effort e, Findings& f) { shear(e, f, "loose"); }},
    Case{"rve.compression", compression},
    Case{"rve.opening", opening},
    Case{"rve.random", random_increments},
    Case{"rve.turns", turns},
};

}  // namespace

std::span<const Case> rve_cases() { return table; }

}  // namespace sandgraph::stability
