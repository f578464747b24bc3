#include "stability/plate_ride.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/contact.hpp"

namespace sandgraph::stability {
namespace {

// How far a point's centre lies inside the plate [m].
double inside(const mpm::Points& points, const mpm::Rectangle& plate) {
    double deepest = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double x = points.x[p], y = points.y[p];
        if (plate.contains(x, y))
            deepest = std::max(deepest, std::min({plate.x1 - x, y - plate.y0, plate.y1 - y}));
    }
    return deepest;
}

}  // namespace

GroundSpec plate_in_ground(Effort effort, double depth, double below) {
    GroundSpec spec;
    spec.cell = effort == Effort::quick ? 0.125 : 0.1;
    spec.soil = {0, 0, 2, below + spec.cell + depth};
    spec.plate = mpm::Rectangle{-0.5, below, 0.5, below + spec.cell};
    spec.grains = effort == Effort::quick ? 100 : 400;
    spec.stepping = [effort](dem::RveOptions& o) {
        if (effort == Effort::quick) o.strain_per_step_max = 1e-4, o.inertial_number_max = 1e-2;
    };
    return spec;
}

double Ride::peak() const { return *std::ranges::max_element(load); }
double Ride::peak_at() const {
    return travel[static_cast<std::size_t>(std::ranges::max_element(load) - load.begin())];
}
double Ride::mean_load(double from, double to) const {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < load.size(); ++k)
        if (travel[k] >= from && travel[k] <= to) sum += load[k], count += 1;
    return sum / count;
}

Ride ride(Ground& ground, const std::function<double(double)>& velocity, const std::function<bool()>& go_on) {
    Ride out;
    const double rest = ground.time() + 0.05, before = ground.plate_work();
    while (go_on()) {
        ground.step({0, ground.time() < rest ? 0 : velocity(ground.time() - rest)});
        const mpm::Reaction& r = ground.body().contact.reaction;
        out.travel.push_back(ground.travelled()), out.load.push_back(ground.load());
        out.trailing_pull = std::max(out.trailing_pull, -r.face(mpm::Face::bottom).y());
        out.leading_pull = std::max(out.leading_pull, r.face(mpm::Face::top).y());
        out.deepest =
            std::max(out.deepest, inside(ground.points(), ground.body().plate.rectangle()) / ground.cell());
        if (std::fabs(ground.travelled()) > 0.005)
            out.kinetic_share =
                std::max(out.kinetic_share, ground.kinetic() / std::max(ground.plate_work() - before, 1e-9));
    }
    return out;
}

Ride pull(Ground& ground, double rate, double distance) {
    const simulation::Programme programme{.rate = rate, .ramp = 0.01};
    return ride(
        ground, [&](double t) { return simulation::rate_at(programme, t); },
        [&] { return ground.travelled() < distance; });
}

void check_ride(Ground& ground, const Ride& ride, Findings& found) {
    found.exactly("largest tension on a face [N/m]", std::max(ride.trailing_pull, ride.leading_pull), 0);
    found.at_most("deepest point inside the plate [cells]", ride.deepest, 0.1);
    found.exactly("updates that failed", static_cast<double>(ground.counters().failures), 0);
    double worst = 0;
    for (const Stress& s : ground.points().stress)
        worst = std::max(worst, std::isfinite(s.xx + s.yy + s.xy) ? std::max(s.xx, s.yy) : 1e300);
    found.at_most("largest tension in the ground at the end [kPa]", worst / 1e3, 1);
}

}  // namespace sandgraph::stability
