#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "stability/ground.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

// A block of sand in the air, its packings at 0.5 kPa: let go, it expands a little and falls.
GroundSpec block(Effort effort, double height) {
    GroundSpec spec;
    spec.soil = {0.6, height, 1.2, height + 0.6};
    spec.wide = 0.6, spec.room = 0.3, spec.damping = 0;
    spec.grains = effort == Effort::quick ? 100 : 400;
    spec.pressure = [](double) { return 500.0; };
    spec.stepping = [effort](dem::RveOptions& o) {
        if (effort == Effort::quick) o.strain_per_step_max = 1e-4, o.inertial_number_max = 1e-2;
    };
    return spec;
}

double mean(const std::vector<double>& v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

double acceleration(double damping, Effort effort) {
    GroundSpec spec = block(effort, 2);
    spec.damping = damping;
    Ground ground(spec);
    const double start = mean(ground.points().y);
    while (ground.time() < 0.3) ground.step();
    // Symplectic Euler: n steps fall by g dt^2 n (n + 1)/2.
    return 2 * (start - mean(ground.points().y)) / (ground.time() * (ground.time() + ground.dt()));
}

void free_fall(Effort effort, Findings& found) {
    found.driven = "block of 36 packings at 0.5 kPa falls freely for 0.3 s";
    found.within("acceleration over g, no grid damping", acceleration(0, effort) / gravity, 1 - 1e-9,
                 1 + 1e-9);
    found.within("acceleration over g, local damping 0.05: it resists all motion",
                 acceleration(0.05, effort) / gravity, 0.9499, 0.9501);
    Ground ground(block(effort, 2));
    double tension = 0, most = 0;
    while (ground.time() < 0.3) {
        ground.step();
        for (const Stress& s : ground.points().stress)
            tension = std::max({tension, s.xx, s.yy}), most = std::max(most, mean_stress(s));
    }
    double late = 0;
    for (const Stress& s : ground.points().stress) late = std::max(late, std::fabs(mean_stress(s)));
    found.at_most("largest tension on the way [kPa]", tension / 1e3, 0.1);
    found.at_most("largest p on the way [kPa]", most / 1e3, 0.75);
    found.at_most("largest p at the end [kPa]", late / 1e3, 0.25);
    found.exactly("updates that failed", static_cast<double>(ground.counters().failures), 0);
}

void impact(Effort effort, Findings& found) {
    const double height = effort == Effort::quick ? 0.3 : 1;
    found.driven = fmt::format("the block falls {:.1f} m onto a rough floor and comes to rest", height);
    Ground ground(block(effort, height));
    const double start = ground.potential(), floor = -ground.potential();
    double kinetic_most = 0, gained = 0, p_most = 0, kinetic = 0;
    const double end = std::sqrt(2 * height / gravity) + (effort == Effort::quick ? 0.6 : 1.5);
    while (ground.time() < end) {
        ground.step();
        kinetic = ground.kinetic();
        kinetic_most = std::max(kinetic_most, kinetic);
        // What the sand stored counts as spent here: kinetic and potential energy alone must not grow past
        // the start.
        gained = std::max(gained, (kinetic + ground.potential() - start) / std::fabs(floor));
        for (const Stress& s : ground.points().stress) p_most = std::max(p_most, mean_stress(s));
    }
    found.at_most("energy gained, share of the drop's", gained * std::fabs(floor) / kinetic_most, 0.01);
    found.at_most("kinetic energy at the end, share of the largest", kinetic / kinetic_most, 0.01);
    found.note("largest p in the impact [kPa]", p_most / 1e3);
    const auto& y = ground.points().y;
    found.at_least("lowest point above the floor [m]", *std::ranges::min_element(y), 0);
    found.at_most("highest point at the end [m]", *std::ranges::max_element(y), 0.7);
    found.exactly("updates that failed", static_cast<double>(ground.counters().failures), 0);
}

constexpr std::array table = {Case{"falling.free", free_fall}, Case{"falling.impact", impact}};

}  // namespace

std::span<const Case> falling_cases() { return table; }

}  // namespace sandgraph::stability
