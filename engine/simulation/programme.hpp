#pragma once
#include "base/tensor.hpp"

namespace sandgraph::simulation {

// How a rigid body is driven along a straight line: at rest while the ground settles, then a smooth ramp to a
// constant rate.
struct Programme {
    Vec2 direction = Vec2(0, 1);  // unit vector
    double rate = 0;              // [m/s]
    double ramp = 0;              // travel over which the rate rises [m]
    double settle = 0;            // [s] at rest before the ramp
    double travel = 0;            // after which it stops [m]; 0: it goes on
};

// Rest before the pull of a plate `width` wide [m] [s]: what a P-wave takes to cross its ground, which goes
// with the width.
double settling_time(double width);

// Rate along the direction at `time` [s] since the start [m/s]: a smoothstep over the ramp, so that the
// acceleration has no jump.
double rate_at(const Programme& programme, double time);

}  // namespace sandgraph::simulation
