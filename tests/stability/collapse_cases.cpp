#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "stability/ground.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

constexpr double kWidth = 0.8;  // of the column, from its symmetry plane [m]

GroundSpec column(Effort effort, double aspect, double cell) {
    GroundSpec spec;
    spec.soil = {0, 0, kWidth, aspect * kWidth};
    spec.wide = cell * std::ceil(2.4 * aspect * kWidth / cell), spec.room = 0.3;
    spec.damping = 0;
    spec.cell = cell;
    spec.grains = effort == Effort::quick ? 100 : 400;
    spec.stepping = [effort](dem::RveOptions& o) {
        o.strain_per_step_max = effort == Effort::quick ? 2e-4 : 1e-4;
        o.inertial_number_max = 1e-2;
    };
    return spec;
}

// The heap: over each cell from the symmetry plane on, how high the sand stands; ends at the first empty
// cell.
std::vector<double> profile(const mpm::Points& points, double cell) {
    std::vector<double> height;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const auto k = static_cast<std::size_t>(points.x[p] / cell);
        if (k >= height.size()) height.resize(k + 1, 0);
        height[k] = std::max(height[k], points.y[p] + points.half);
    }
    height.resize(static_cast<std::size_t>(std::ranges::find(height, 0.0) - height.begin()));
    return height;
}

// What became of a column that was let go.
struct Heap {
    double runout = 0, height = 0;        // [m]
    double kinetic_late = 0, gained = 0;  // at the end, share of the largest; share of the column's potential
    graph::RveCounters counters;
};

Heap let_go(const GroundSpec& spec) {
    Ground ground(spec);
    const double potential = ground.potential();
    double kinetic_most = 0;
    Heap out;
    while (ground.time() < 4 * std::sqrt(spec.soil.y1 / gravity)) {
        ground.step();
        kinetic_most = std::max(kinetic_most, ground.kinetic());
        out.gained =
            std::max(out.gained, (ground.kinetic() + ground.potential() - potential) / std::fabs(potential));
    }
    const std::vector<double> heap = profile(ground.points(), spec.cell);
    out.runout = static_cast<double>(heap.size()) * spec.cell - kWidth, out.height = heap.front();
    out.kinetic_late = ground.kinetic() / kinetic_most, out.counters = ground.counters();
    return out;
}

// The same column of a sand of 5 MPa that keeps one friction angle [deg] and its volume: what the grid alone,
// and what the friction makes of it.
void twin(Findings& found, GroundSpec spec, double friction, double runout, double height) {
    spec.plastic = {5e6, 0.3, friction * std::numbers::pi / 180, 0, 0};
    const Heap heap = let_go(spec);
    const std::string sand = fmt::format(", Mohr-Coulomb of {} deg, cells of {} m", friction, spec.cell);
    found.note("run-out over that of Lube et al." + sand, heap.runout / runout);
    found.note("height of the heap over theirs" + sand, heap.height / height);
}

// Lube, Huppert, Sparks & Freundt (2005), plane columns on a rough floor, by their end at 3.3 sqrt(H/g):
// run-out over width 1.2 a below a = 1.8 (fits to 2.3 within a tenth); height of the heap H below a = 1.15,
// width a^0.4 above. The front of a heap is thinner than a cell: on coarse cells it is missing, and what is
// missing shrinks with the cells.
void collapse(Effort effort, Findings& found, double aspect, double finest = 0.05) {
    const bool quick = effort == Effort::quick;
    found.driven =
        fmt::format("column of packings, height {} times its half width {} m, let go", aspect, kWidth);
    const double theirs = 1.2 * aspect * kWidth;
    double cell = 0.1;
    Heap coarse, fine = let_go(column(effort, aspect, cell));
    while (!quick && cell > 1.01 * finest) {
        found.note(fmt::format("run-out over that of Lube et al., 1.2 a, cells of {} m", cell),
                   fine.runout / theirs);
        cell /= 2, coarse = fine;
        fine = let_go(column(effort, aspect, cell));
    }
    found.within(fmt::format("run-out over that of Lube et al., 1.2 a, cells of {} m", cell),
                 fine.runout / theirs, quick ? 0.35 : 0.9, quick ? 1.35 : 1.1);
    found.because(quick ? "a guard: two or three of eight cells are missing at the front"
                        : "scatter of their experiments");
    if (!quick)
        found.within("the same, straight on to cells of no size", (2 * fine.runout - coarse.runout) / theirs,
                     0.9, 1.1);
    const double height = aspect < 1.15 ? aspect * kWidth : kWidth * std::pow(aspect, 0.4);
    found.within("height of the heap over theirs", fine.height / height, quick ? 0.7 : 0.9,
                 quick ? 1.15 : 1.1);
    found.at_most("kinetic energy at the end, share of the largest", fine.kinetic_late, quick ? 0.2 : 0.05);
    found.at_most("energy gained, share of the column's potential", fine.gained, 0.005);
    found.exactly("updates that failed", static_cast<double>(fine.counters.failures), 0);
    found.note("largest inertial number of an update", fine.counters.inertial_number_max);
    if (quick) return;
    for (const double friction : {20.5, 31.0})  // of the packings past the peak; of their sand at repose
        twin(found, column(effort, aspect, cell), friction, theirs, height);
}

constexpr std::array table = {
    Case{"collapse.aspect_0.5", [](Effort e, Findings& f) { collapse(e, f, 0.5, 0.025); }},
    Case{"collapse.aspect_1", [](Effort e, Findings& f) { collapse(e, f, 1); }},
    Case{"collapse.aspect_2",
         [](Effort e, Findings& f) {
             if (e == Effort::full) collapse(e, f, 2);
         }},
};

}  // namespace

std::span<const Case> collapse_cases() { return table; }

}  // namespace sandgraph::stability
