#include <fmt/format.h>

#include <array>
#include <cmath>

#include "mpm/audit.hpp"
#include "stability/plate_ride.hpp"

namespace sandgraph::stability {
namespace {

constexpr double kDepth = 0.75, kCell = 0.125;

// Plate 0.75 m deep, 0.125 m thick, on one mesh or another; the same packings and pull.
Ride on_mesh(Effort effort, Findings& found, double cell, int per_cell, double distance) {
    GroundSpec spec = plate_in_ground(effort, kDepth, 0.75);
    spec.plate = mpm::Rectangle{-0.5, 0.75, 0.5, 0.75 + kCell};
    spec.soil.y1 = 0.75 + kCell + kDepth;
    spec.cell = cell, spec.per_cell = per_cell;
    Ground ground(spec);
    const Ride r = pull(ground, effort == Effort::quick ? 0.4 : 0.1, distance);
    found.exactly(fmt::format("updates that failed, {} points a cell of {} m", per_cell, cell),
                  static_cast<double>(ground.counters().failures), 0);
    return r;
}

void points_a_cell(Effort effort, Findings& found) {
    const double distance = effort == Effort::quick ? 0.02 : 0.1;
    found.driven = fmt::format("plate 0.75 m deep pulled by {} B with 1, 4 and 9 points a cell", distance);
    const Ride one = on_mesh(effort, found, kCell, 1, distance);
    for (const int n : {4, 9}) {
        if (n == 9 && effort == Effort::quick) continue;
        const Ride many = on_mesh(effort, found, kCell, n, distance);
        found.within(fmt::format("peak load, {} points over 1", n), many.peak() / one.peak(), 0.8, 1.2);
        found.within(fmt::format("late load, {} points over 1", n),
                     many.mean_load(0.9 * distance, distance) / one.mean_load(0.9 * distance, distance), 0.7,
                     1.3);
    }
}

// The paper's appendix: the finer mesh gives the same pattern and a slightly lower load past the peak.
void cells(Effort effort, Findings& found) {
    const double coarse = effort == Effort::quick ? 0.125 : 0.1,
                 distance = effort == Effort::quick ? 0.02 : 0.1;
    found.driven = fmt::format("plate 0.75 m deep pulled by {} B with cells of {} and {} m", distance, coarse,
                               coarse / 2);
    const auto ride_on = [&](double cell) {
        GroundSpec spec = plate_in_ground(effort, 1, 1);
        spec.plate = mpm::Rectangle{-0.5, 1, 0.5, 1 + coarse};
        spec.soil.y1 = 2 + coarse, spec.cell = cell;
        Ground ground(spec);
        const Ride r = pull(ground, effort == Effort::quick ? 0.4 : 0.1, distance);
        found.exactly(fmt::format("updates that failed, cells of {} m", cell),
                      static_cast<double>(ground.counters().failures), 0);
        return r;
    };
    const Ride a = ride_on(coarse), b = ride_on(coarse / 2);
    found.within("peak load, fine over coarse", b.peak() / a.peak(), 0.8, 1.1);
    found.within("d/B at the peak, fine over coarse", b.peak_at() / a.peak_at(), 0.4, 1.6);
    found.within("late load, fine over coarse",
                 b.mean_load(0.8 * distance, distance) / a.mean_load(0.8 * distance, distance), 0.7, 1.1);
}

// Ground on a plate that carries it up through the grid at 3 m/s, every phase of the grid met many times.
void crossing(Effort effort, Findings& found, int per_cell) {
    const double rate = 3, way = effort == Effort::quick ? 1 : 3;
    found.driven = fmt::format("block carried up by {} m through cells of 0.1 m at {} m/s, {} points a cell",
                               way, rate, per_cell);
    GroundSpec spec;
    spec.soil = {0, 0.3, 0.5, 1.1};
    spec.plate = mpm::Rectangle{-0.5, 0.2, 0.5, 0.3};
    spec.room = way + 0.5, spec.damping = 0, spec.per_cell = per_cell;
    spec.grains = effort == Effort::quick ? 100 : 400;
    spec.surcharge = 50e3;
    Ground ground(spec);
    for (double& v : ground.points().vy) v = rate;
    const auto before = ground.points().stress;
    const double kinetic = ground.kinetic();
    double drift = 0;
    while (ground.travelled() < way) {
        ground.step({0, rate});
        drift = std::max(drift, stress_drift(ground.points(), before));
    }
    const double row = ground.density() * gravity * spec.cell / spec.surcharge;
    found.at_most("largest change of stress, share of p", drift, row);
    found.because(
        "weight of a cell's height: the nodes see only the sum of the rows that share a cell, not their "
        "difference");
    found.at_most("change of kinetic energy, share", std::fabs(ground.kinetic() / kinetic - 1), 0.01);
    found.exactly("updates that failed", static_cast<double>(ground.counters().failures), 0);
}

constexpr std::array table = {
    Case{"mesh.crossing.1_point", [](Effort e, Findings& f) { crossing(e, f, 1); }},
    Case{"mesh.crossing.4_points", [](Effort e, Findings& f) { crossing(e, f, 4); }},
    Case{"mesh.crossing.9_points", [](Effort e, Findings& f) { crossing(e, f, 9); }},
    Case{"mesh.points_a_cell", points_a_cell},
    Case{"mesh.cells", cells},
};

}  // namespace

std::span<const Case> mesh_cases() { return table; }

}  // namespace sandgraph::stability
