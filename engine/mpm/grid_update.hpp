#pragma once
#include "mpm/boundary.hpp"
#include "mpm/grid.hpp"

namespace sandgraph::mpm {

struct GridStep {
    double dt = 0;                // [s]
    Vec2 gravity = Vec2::Zero();  // [m/s2]
    double damping = 0;           // local (Cundall): alpha in f -= alpha |f| sign(v)
    double mass_scaling = 1;      // multiplies inertia, not weight
    Boundaries boundaries;
    double light =
        0;  // a lighter node beside heavier ones follows them [kg/m] (light_nodes.hpp); 0: none does
};

// v = p/m, f += m g, f -= alpha |f| sign(v + dt f/(s m)) by component, a = f/(s m), v += dt a, then the
// boundaries. Light nodes follow their neighbours. Nodes too light to have a velocity beyond round-off stay
// at rest. dt, mass_scaling > 0 and 0 <= damping < 1. Contact and surcharge forces are in f already, so that
// damping sees the unbalanced force alone.
void update_grid(const GridStep& step, Grid& grid);

}  // namespace sandgraph::mpm
