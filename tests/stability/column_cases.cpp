#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.hpp"
#include "stability/ground.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

GroundSpec column(Effort effort) {
    GroundSpec spec;
    spec.soil = {0, 0, 0.4, 2};
    spec.grains = effort == Effort::quick ? 100 : 400;
    return spec;
}

// What a column does while nothing drives it.
struct Rest {
    double settlement = 0, drift = 0;            // largest [m]; of a stress, share of p
    double kinetic_first = 0, kinetic_last = 0;  // largest in the first and the last fifth [J/m]
    double K_low = 0, K_high = 0;                // s_xx/s_yy of the rows deeper than 0.3 m, at the end
};

Rest at_rest(Ground& ground, int steps) {
    Rest rest;
    const mpm::Points start = ground.points();
    for (int k = 0; k < steps; ++k) {
        ground.step();
        const double kinetic = ground.kinetic();
        if (5 * k < steps) rest.kinetic_first = std::max(rest.kinetic_first, kinetic);
        if (5 * k >= 4 * steps) rest.kinetic_last = std::max(rest.kinetic_last, kinetic);
    }
    const mpm::Points& now = ground.points();
    rest.drift = stress_drift(now, start.stress);
    rest.K_low = 1e9;
    for (std::size_t p = 0; p < now.size(); ++p) {
        rest.settlement = std::max(rest.settlement, std::fabs(now.y[p] - start.y[p]));
        if (start.y[p] > 1.7) continue;
        const double K = now.stress[p].xx / now.stress[p].yy;
        rest.K_low = std::min(rest.K_low, K), rest.K_high = std::max(rest.K_high, K);
    }
    return rest;
}

void quiet(Effort effort, Findings& found, GroundSpec spec, const char* how) {
    const int steps = effort == Effort::quick ? 5000 : 50'000;
    found.driven = fmt::format("column 2 m deep under its own weight, {}, {} steps", how, steps);
    Ground ground(spec);
    const Rest rest = at_rest(ground, steps);
    found.at_most("largest settlement [mm]", 1e3 * rest.settlement, 0.05);
    found.at_most("stress drift, share of p", rest.drift, 0.02);
    found.within("K0 below 0.3 m: lowest", rest.K_low, 0.95, 1.05);
    found.within("K0 below 0.3 m: highest", rest.K_high, 0.95, 1.05);
    found.at_most("kinetic energy, last fifth over first", rest.kinetic_last / rest.kinetic_first, 1);
    found.exactly("updates that failed", static_cast<double>(ground.counters().failures), 0);
}

// The same after a kick of random velocities: the ringing must die, with or without damping.
void shaken(Effort effort, Findings& found, GroundSpec spec, const char* how) {
    const int steps = effort == Effort::quick ? 5000 : 50'000;
    found.driven = fmt::format("the column, every point kicked by up to 10 mm/s, {}, {} steps", how, steps);
    Ground ground(spec);
    Random random(7);
    mpm::Points& points = ground.points();
    for (std::size_t p = 0; p < points.size(); ++p)
        points.vx[p] = random.uniform(-0.01, 0.01), points.vy[p] = random.uniform(-0.01, 0.01);
    const double kick = ground.kinetic(), potential = ground.potential();
    const Rest rest = at_rest(ground, steps);
    const double stored = ground.kinetic() + ground.potential() - potential + ground.state().stress_work;
    found.at_most("energy left, share of the kick", stored / kick, 1);
    // Without grid damping the grains alone take it, slowly.
    const double most = effort == Effort::quick ? 0.1 : 0.05;
    found.at_most("kinetic energy of the last fifth, share of the kick", rest.kinetic_last / kick, most);
    found.at_most("largest settlement [mm]", 1e3 * rest.settlement, 0.5);
    found.within("K below 0.3 m: lowest", rest.K_low, 0.7, 1.4);
    found.within("K below 0.3 m: highest", rest.K_high, 0.7, 1.4);
    found.exactly("updates that failed", static_cast<double>(ground.counters().failures), 0);
}

GroundSpec with(Effort effort, double damping, double courant, int per_cell, double cell) {
    GroundSpec spec = column(effort);
    spec.damping = damping, spec.courant = courant, spec.per_cell = per_cell, spec.cell = cell;
    return spec;
}
GroundSpec screening(GroundSpec spec) {
    spec.screening = [](graph::ScreeningSetup&) {};
    return spec;
}

// step.limit measures where the ground becomes unstable: 0.7 cell/c. A scene cannot ask for more than 0.5.
constexpr double kLongStep = 0.95 * 0.7;
constexpr const char* kLongStepText = "0.95 of the stable step";

constexpr std::array table = {
    Case{"column.rest.full",
         [](Effort e, Findings& f) { quiet(e, f, with(e, 0.05, 0.3, 1, 0.1), "full fidelity"); }},
    Case{"column.rest.undamped",
         [](Effort e, Findings& f) { quiet(e, f, with(e, 0, 0.3, 1, 0.1), "no grid damping"); }},
    Case{"column.rest.screening",
         [](Effort e, Findings& f) { quiet(e, f, screening(with(e, 0.05, 0.3, 1, 0.1)), "screening"); }},
    Case{"column.rest.4_points",
         [](Effort e, Findings& f) { quiet(e, f, with(e, 0.05, 0.3, 4, 0.1), "4 points a cell"); }},
    Case{"column.rest.9_points",
         [](Effort e, Findings& f) { quiet(e, f, with(e, 0.05, 0.3, 9, 0.1), "9 points a cell"); }},
    Case{"column.rest.fine",
         [](Effort e, Findings& f) { quiet(e, f, with(e, 0.05, 0.3, 1, 0.05), "cells of 0.05 m"); }},
    Case{"column.rest.long_step",
         [](Effort e, Findings& f) { quiet(e, f, with(e, 0.05, kLongStep, 1, 0.1), kLongStepText); }},
    Case{"column.shaken.full",
         [](Effort e, Findings& f) { shaken(e, f, with(e, 0.05, 0.3, 1, 0.1), "full fidelity"); }},
    Case{"column.shaken.undamped",
         [](Effort e, Findings& f) { shaken(e, f, with(e, 0, 0.3, 1, 0.1), "no grid damping"); }},
    Case{"column.shaken.screening",
         [](Effort e, Findings& f) { shaken(e, f, screening(with(e, 0.05, 0.3, 1, 0.1)), "screening"); }},
    Case{"column.shaken.long_step",
         [](Effort e, Findings& f) { shaken(e, f, with(e, 0.05, kLongStep, 1, 0.1), kLongStepText); }},
};

}  // namespace

std::span<const Case> column_cases() { return table; }

}  // namespace sandgraph::stability
