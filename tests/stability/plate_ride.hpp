#pragma once
#include <functional>

#include "stability/ground.hpp"
#include "stability/suite.hpp"

namespace sandgraph::stability {

// Half model of a plate of width 1 m in 2 m of ground, its top face `depth` below the surface. Depths that
// are multiples of both meshes (0.125 and 0.1 m): a point whose domain overlaps the plate would be shot away.
GroundSpec plate_in_ground(Effort effort, double depth, double below = 1);

// What happened to ground and plate on a ride.
struct Ride {
    std::vector<double> travel, load;  // after each step, up [m]; [N/m], of the half model
    double trailing_pull = 0;          // largest tension on the bottom face [N/m]
    double leading_pull = 0;           // the same on the top face
    double deepest = 0;                // a point's centre inside the plate, in cells
    double kinetic_share = 0;          // largest kinetic energy over the plate's work, once travelled 0.005 m
    double peak() const;
    double peak_at() const;  // [m]
    // Mean load over [from, to] of the travel [N/m].
    double mean_load(double from, double to) const;
};

// Rests for 0.05 s, then moves the plate at `velocity` (of the time since) while `go_on`.
Ride ride(Ground& ground, const std::function<double(double)>& velocity, const std::function<bool()>& go_on);
// At `rate` over `distance` with a smooth start over 10 mm.
Ride pull(Ground& ground, double rate, double distance);

// What holds for every ride.
void check_ride(Ground& ground, const Ride& ride, Findings& found);

}  // namespace sandgraph::stability
