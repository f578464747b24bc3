#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "stability/plate_ride.hpp"
#include "stability/tampered_surrogate.hpp"

namespace sandgraph::stability {
namespace {

constexpr double kDistance = 0.04;  // of the pull [B]

double rate(Effort effort) { return effort == Effort::quick ? 0.4 : 0.1; }
GroundSpec ground_spec(Effort effort) { return plate_in_ground(effort, 1); }

// A gate that nothing passes but a large spread and a singular acoustic tensor.
void only_spread(graph::ScreeningSetup& setup) {
    setup.gate = {
        .strain = 1e9, .stress_ratio = 1e9, .tension = 0, .distance = 1e9, .second_order_work = -1e9};
    setup.hand_over.dilate = 0;
}

void tamper(graph::ScreeningSetup& setup, TamperedSurrogate::Tamper how) {
    setup.surrogate = std::make_shared<TamperedSurrogate>(setup.surrogate, std::move(how));
}

Ride full_ride(Effort effort) {
    Ground full(ground_spec(effort));
    return pull(full, rate(effort), kDistance);
}

// Energy and continuity of what the switches did, and the load against a run of packings alone.
void check_switches(Ground& ground, const Ride& r, const Ride& full, Findings& found) {
    const graph::ScreeningLaw& law = ground.screening();
    double jump = 0;
    for (const stress::Switch& s : law.screening_log()->switches)
        jump += s.jump / static_cast<double>(law.screening_log()->switches.size());
    check_ride(ground, r, found);
    found.within("energy that the fading jumps put in, share of the plate's work",
                 law.screening_log()->counters.jump_work / ground.plate_work(), -0.1, 0.1);
    found.note("mean stress jump at a switch, share of p", jump);
    found.at_most("kinetic energy over the plate's work, times that of packings alone",
                  r.kinetic_share / full.kinetic_share, 1.5);
    found.within("largest load over that of packings alone", r.peak() / full.peak(), 0.8, 1.2);
    found.within("late load over that of packings alone",
                 r.mean_load(0.9 * kDistance, kDistance) / full.mean_load(0.9 * kDistance, kDistance), 0.75,
                 1.25);
}

void checkerboard(Effort effort, Findings& found) {
    found.driven = "plate 1 m deep; every other point, like a checkerboard, is handed to its grains at once";
    GroundSpec spec = ground_spec(effort);
    const auto columns = static_cast<std::int32_t>(std::lround(spec.soil.x1 / spec.cell));
    const auto black = [columns](std::int32_t point) { return (point / columns + point % columns) % 2 == 1; };
    spec.screening = [&](graph::ScreeningSetup& setup) {
        only_spread(setup);
        setup.gate.acoustic = -1e9;
        tamper(setup,
               [black](std::int32_t point, stress::SurrogateAnswer& a) { a.spread = black(point) ? 10 : 0; });
    };
    Ground ground(spec);
    const Ride r = pull(ground, rate(effort), kDistance);
    check_switches(ground, r, full_ride(effort), found);
    double blacks = 0, handed = 0, others = 0;
    for (std::size_t p = 0; p < ground.points().size(); ++p) blacks += black(static_cast<std::int32_t>(p));
    for (const stress::Switch& s : ground.screening().screening_log()->switches)
        (black(s.point) ? handed : others) += 1;
    found.exactly("black squares handed over, share of them", handed / blacks, 1);
    found.at_most("white squares handed over, share of the points",
                  others / static_cast<double>(ground.points().size()), 0.05);
    found.because("no threshold can be passed there: refused answers alone");
}

void all_at_once(Effort effort, Findings& found) {
    found.driven = "plate 1 m deep; thresholds that every point passes in its first steps";
    GroundSpec spec = ground_spec(effort);
    spec.screening = [](graph::ScreeningSetup& setup) {
        setup.gate.strain = 1e-9, setup.gate.flow = 0, setup.hand_over.dilate = 1000,
        setup.hand_over.replay_steps = 100'000;
        setup.visits.update_tolerance = 1e-9, setup.visits.update_change_max = 1e-9;
    };
    Ground ground(spec);
    const Ride r = pull(ground, rate(effort), kDistance);
    check_switches(ground, r, full_ride(effort), found);
    const auto& switches = ground.screening().screening_log()->switches;
    found.exactly("points handed over", static_cast<double>(switches.size()),
                  static_cast<double>(ground.points().size()));
    found.at_most("steps from the first switch to the last",
                  static_cast<double>(switches.back().step - switches.front().step), 50);
}

// Near the largest load every point that is asked goes to its grains.
void in_mid_peak(Effort effort, Findings& found) {
    found.driven = "plate 1 m deep; surrogate alone to 0.012 B, then every point that strains is handed over";
    bool distrust = false;
    GroundSpec spec = ground_spec(effort);
    spec.screening = [&](graph::ScreeningSetup& setup) {
        only_spread(setup);
        tamper(setup,
               [&distrust](std::int32_t, stress::SurrogateAnswer& a) { a.spread = distrust ? 10 : 0; });
    };
    Ground ground(spec);
    const simulation::Programme programme{.rate = rate(effort), .ramp = 0.01};
    const Ride r = ride(
        ground, [&](double t) { return simulation::rate_at(programme, t); },
        [&] {
            distrust = ground.travelled() > 0.012;
            return ground.travelled() < kDistance;
        });
    check_switches(ground, r, full_ride(effort), found);
    found.at_least("points handed over",
                   static_cast<double>(ground.screening().screening_log()->switches.size()), 50);
}

constexpr std::array table = {Case{"gate.checkerboard", checkerboard}, Case{"gate.all_at_once", all_at_once},
                              Case{"gate.mid_peak", in_mid_peak}};

}  // namespace

std::span<const Case> gate_cases() { return table; }

}  // namespace sandgraph::stability
