#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "stability/ground.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

constexpr double kWidth = 0.8;  // of the column, from its symmetry plane [m]

GroundSpec column(Effort effort, double aspect) {
    GroundSpec spec;
    spec.soil = {0, 0, kWidth, aspect * kWidth};
    spec.wide = 2.4 * aspect * kWidth, spec.room = 0.3;
    spec.damping = 0;
    spec.cell = effort == Effort::quick ? 0.1 : 0.05;
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

// Lube, Huppert, Sparks & Freundt (2005), plane columns on a rough floor, by their end at 3.3 sqrt(H/g):
// run-out over width 1.2 a below a = 1.8 (fits to 2.3 within a tenth); height of the heap H below a = 1.15,
// width a^0.4 above.
void collapse(Effort effort, Findings& found, double aspect) {
    found.driven =
        fmt::format("column of packings, height {} times its half width {} m, let go", aspect, kWidth);
    const GroundSpec spec = column(effort, aspect);
    Ground ground(spec);
    const double tall = aspect * kWidth, potential = ground.potential();
    double kinetic_most = 0, gained = 0;
    while (ground.time() < 4 * std::sqrt(tall / gravity)) {
        ground.step();
        kinetic_most = std::max(kinetic_most, ground.kinetic());
        gained = std::max(gained, (ground.kinetic() + ground.potential() - potential) / std::fabs(potential));
    }
    const std::vector<double> heap = profile(ground.points(), spec.cell);
    const double runout = (static_cast<double>(heap.size()) * spec.cell - kWidth) / kWidth;
    const double height = aspect < 1.15 ? tall : kWidth * std::pow(aspect, 0.4);
    // With 8 cells across, the thin front of the heap is lost in the last cell or two.
    const double least = effort == Effort::quick ? 0.35 : 0.7;
    found.within("run-out over that of Lube et al., 1.2 a", runout / (1.2 * aspect), least, 1.35);
    found.within("height of the heap over theirs", heap.front() / height, 0.7, 1.15);
    found.at_most("kinetic energy at the end, share of the largest", ground.kinetic() / kinetic_most,
                  effort == Effort::quick ? 0.2 : 0.05);
    found.at_most("energy gained, share of the column's potential", gained, 0.005);
    found.exactly("updates that failed", static_cast<double>(ground.counters().failures), 0);
    found.note("largest inertial number of an update", ground.counters().inertial_number_max);
}

constexpr std::array table = {
    Case{"collapse.aspect_0.5", [](Effort e, Findings& f) { collapse(e, f, 0.5); }},
    Case{"collapse.aspect_1", [](Effort e, Findings& f) { collapse(e, f, 1); }},
    Case{"collapse.aspect_2",
         [](Effort e, Findings& f) {
             if (e == Effort::full) collapse(e, f, 2);
         }},
};

}  // namespace

std::span<const Case> collapse_cases() { return table; }

}  // namespace sandgraph::stability
