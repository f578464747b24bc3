#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "stability/plate_ride.hpp"

namespace sandgraph::stability {
namespace {

void screen(GroundSpec& spec) {
    spec.screening = [](graph::ScreeningSetup&) {};
}

// A cavity below the plate opens and closes, and one above it, as the plate goes up and down.
void cycling(Effort effort, Findings& found, bool screening) {
    const double amplitude = 0.03, peak_rate = effort == Effort::quick ? 0.4 : 0.2;
    const int cycles = effort == Effort::quick ? 2 : 10;
    found.driven = fmt::format("plate 1 m deep, up and down by 0.03 B, {} cycles{}", cycles,
                               screening ? ", screening" : "");
    GroundSpec spec = plate_in_ground(effort, 1);
    if (screening) screen(spec);
    Ground ground(spec);
    const double omega = peak_rate / amplitude, end = 0.05 + cycles * 2 * std::numbers::pi / omega;
    const double weight = ground.density() * gravity;  // of a cubic metre [N]
    const Ride r = ride(
        ground, [&](double t) { return peak_rate * std::sin(omega * t) * std::min(1.0, omega * t); },
        [&] { return ground.time() < end; });
    check_ride(ground, r, found);
    found.within("largest load over gamma H B (half model)", r.peak() / (0.5 * weight), 1, 12);
    const double last = r.mean_load(0.02, 0.06);
    found.at_least("mean load near the top of the strokes over gamma H B", last / (0.5 * weight), 0.3);
    found.at_most("plate over its mean height at the end [m]", std::fabs(ground.travelled()), 0.07);
}

// Out of the ground and into the air; what lies on the plate is its load in the end.
void out_of_the_ground(Effort effort, Findings& found, bool screening) {
    const double rate = effort == Effort::quick ? 0.5 : 0.2, depth = 0.5, lift = 0.9;
    found.driven =
        fmt::format("plate 0.5 m deep, pulled up by 0.9 B at {} m/s{}", rate, screening ? ", screening" : "");
    GroundSpec spec = plate_in_ground(effort, depth);
    spec.room = 1.5;
    if (screening) screen(spec);
    Ground ground(spec);
    const Ride r = pull(ground, rate, lift);
    check_ride(ground, r, found);
    double carried = 0;
    const mpm::Rectangle plate = ground.body().plate.rectangle();
    for (std::size_t p = 0; p < ground.points().size(); ++p)
        if (ground.points().x[p] < plate.x1 + ground.points().half && ground.points().y[p] > plate.y1)
            carried += ground.points().mass[p] * gravity;
    found.at_least("largest load over the one at the end", r.peak() / r.mean_load(lift - 0.05, lift), 1.2);
    found.within("load at the end over the weight of what lies on the plate",
                 r.mean_load(lift - 0.05, lift) / carried, 0.6, 1.4);
    found.exactly("force on the bottom face at the end [N/m]",
                  ground.body().contact.reaction.face(mpm::Face::bottom).norm(), 0);
}

void check_inertia(Effort effort, const Ride& r, Findings& found) {
    const bool quick = effort == Effort::quick;
    found.at_most("kinetic energy over the plate's work", r.kinetic_share, quick ? 0.5 : 0.1);
    found.because(quick
                      ? "four to five times as fast as in full: not quasi-static, a guard against blowing up"
                      : "the usual limit of quasi-static loading, 5 to 10 %");
}

// H/B = 50 stood for by a surcharge: packings near 1 MPa.
void deep(Effort effort, Findings& found) {
    found.driven = "plate 1 m deep under a surcharge of 1.07 MPa (H/B = 50), pulled by 0.05 B";
    GroundSpec spec = plate_in_ground(effort, 1);
    spec.surcharge = 49 * 2230 * gravity;
    Ground ground(spec);
    const auto before = ground.points().stress;
    const Ride r = pull(ground, effort == Effort::quick ? 0.5 : 0.1, 0.05);
    const double p = spec.surcharge + ground.density() * gravity;
    check_ride(ground, r, found);
    found.within("load over p B at the end (half model)", r.mean_load(0.045, 0.05) / (0.5 * p), 0.5, 12);
    check_inertia(effort, r, found);
    found.note("largest change of stress, share of p", stress_drift(ground.points(), before));
}

void shallow(Effort effort, Findings& found) {
    found.driven = "top row at 1.1 kPa: plate 0.5 m deep, pulled by 0.1 B";
    Ground ground(plate_in_ground(effort, 0.5));
    const mpm::Points start = ground.points();
    const Ride r = pull(ground, effort == Effort::quick ? 0.2 : 0.05, 0.1);
    check_ride(ground, r, found);
    double settled = 0, ratio = 0;
    for (const std::int32_t p : start.surface) {
        if (start.x[p] < 1.5) continue;  // away from the wedge
        settled = std::max(settled, std::fabs(ground.points().y[p] - start.y[p]));
        ratio = std::max(ratio, std::fabs(ground.points().stress[p].yy / start.stress[p].yy));
    }
    found.at_most("far surface points have moved by [m]", settled, 0.02);
    found.at_most("vertical stress of far surface points over that at the start", ratio, 2);
    check_inertia(effort, r, found);
    const double weight = 0.5 * 0.5 * ground.density() * gravity;
    found.within("largest load over gamma H B (half model)", r.peak() / weight, 1, 3.5);
}

constexpr std::array table = {
    Case{"plate.cycling", [](Effort e, Findings& f) { cycling(e, f, false); }},
    Case{"plate.cycling.screening", [](Effort e, Findings& f) { cycling(e, f, true); }},
    Case{"plate.pulled_out", [](Effort e, Findings& f) { out_of_the_ground(e, f, false); }},
    Case{"plate.pulled_out.screening",
         [](Effort e, Findings& f) {
             if (e == Effort::full) out_of_the_ground(e, f, true);
         }},
    Case{"plate.deep", deep},
    Case{"plate.shallow", shallow},
};

}  // namespace

std::span<const Case> plate_cases() { return table; }

}  // namespace sandgraph::stability
