#pragma once
#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::mpm {

// Numerical settings of a step, with their only defaults: the scene's keys [mpm] bind to these members.
struct Scheme {
    double courant = 0.3;          // dt c/cell
    double damping = 0.05;         // local (non-viscous) grid damping
    double pic_fraction = 0.01;    // share of PIC in the velocity update in a usual step, the rest FLIP
    double mass_scaling = 1;       // inertia multiplied, gravity kept
    double contact_stiffness = 1;  // plate-soil penalty, in units of M/cell
    double hourglass = 0.1;        // own share of a point's strain beside its cell's mean; 1: all of it
    bool light_nodes = true;       // nodes with next to no mass follow their neighbours
};

// What the time step is bounded by beside the scheme: cell [m], P-wave modulus M [Pa], density [kg/m3].
struct Medium {
    double cell = 0, p_wave_modulus = 0, density = 0;
};

// What a P-wave takes through a cell, cell / c with c = sqrt(M / (s rho)) [s].
inline double crossing_time(const Scheme& scheme, const Medium& m) {
    return m.cell * std::sqrt(m.density * scheme.mass_scaling / m.p_wave_modulus);
}

// dt = courant cell / c [s], bounded. A body's penalty on the lightest node beside it
// adds 4 kappa to (omega cell / c)^2 of the grid, 4. The bound keeps dt omega at 0.9: undamped ground stays
// bounded over 10,000 steps at 0.95 and gains energy at 1 (tests/stability, step.limit).
inline double time_step(const Scheme& scheme, const Medium& m) {  // docs/how_it_works.md (eq. 11)
    SG_EXPECT(scheme.courant > 0 && scheme.mass_scaling > 0 && scheme.contact_stiffness >= 0);
    SG_EXPECT(m.cell > 0 && m.p_wave_modulus > 0 && m.density > 0);
    return crossing_time(scheme, m) *
           std::min(scheme.courant, 0.45 / std::sqrt(1 + scheme.contact_stiffness));
}

inline constexpr double usual_courant = Scheme{}.courant;

// Share of PIC in a step of dt [s] that takes as much from a motion in a given time as `pic_fraction` does in
// steps of courant 0.3: exactly that in such a step, less in a shorter one.
inline double pic_share(const Scheme& scheme, const Medium& m, double dt) {  // (eq. 8a)
    SG_EXPECT(dt > 0 && scheme.pic_fraction >= 0 && scheme.pic_fraction <= 1);
    const double steps = dt / (usual_courant * crossing_time(scheme, m));
    return steps == 1 ? scheme.pic_fraction : 1 - std::pow(1 - scheme.pic_fraction, steps);
}

}  // namespace sandgraph::mpm
