#pragma once
#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "base/tensor.hpp"
#include "dem/material.hpp"

namespace sandgraph::dem {

// The contact law of the reference step, literally as published (YADE ScGeom6D + CohFrictPhys, 2D):
// n points from i to j, forces act on j, moments are about z and act on j. Equations: docs/how_it_works.md.

// Constants of a pair (i, j) (eqs. 17 to 19): radii [m], k_n and k_t [N/m], k_r [N m], rolling arm eta min(r)
// [m].
struct PairConstants {
    double r_i, r_j, k_n, k_t, k_r, rolling_arm;
    PairConstants(double ri, double rj, const Material& m)
        : r_i(ri),
          r_j(rj),
          k_n(m.young * (2 * ri * rj / (ri + rj))),
          k_t(m.stiffness_ratio * k_n),
          k_r(m.rolling_stiffness * k_t * ri * rj),
          rolling_arm(m.rolling_limit * std::min(ri, rj)) {}
};

// What a pair does in one step: branch d = x_j + H c - x_i [m], dv = v_j - v_i + L H c [m/s], spins [rad/s],
// relative rotation theta_j - theta_i since the last force evaluation [rad].
struct PairMotion {
    Vec2 d, dv;
    double spin_i, spin_j, rotation;
};

struct ContactState {
    Vec2 n = Vec2::Zero();        // unit normal of the last step
    Vec2 f_t = Vec2::Zero();      // tangential force on j [N]
    double f_n = 0, overlap = 0;  // [N], [m]
    double rolling =
        0;  // moment memory [N m]: the moment itself (incremental), or uncapped -k_r theta (total)
    double moment = 0;  // moment on j [N m], capped at eta min(r) f_n
    bool in_contact = false;
};

// First-order turn of f_t with the contact plane, not renormalised (eq. 18).
inline void turn_tangential(ContactState& t, const Vec2& n) {
    const double a = t.n.x() * n.y() - t.n.y() * n.x();
    t.f_t -= a * Vec2(t.f_t.y(), -t.f_t.x());
}

// Sliding increment with full radii as lever arms, which avoids granular ratcheting (eq. 18).
inline Vec2 sliding_velocity(const PairConstants& c, const PairMotion& m, const Vec2& n, double overlap) {
    const double radii = c.r_i + c.r_j, alpha = radii / (radii - overlap);
    const Vec2 v = alpha * m.dv + (c.r_j * m.spin_j + c.r_i * m.spin_i) * Vec2(n.y(), -n.x());
    return v - n.dot(v) * n;
}

inline void limit_tangential(ContactState& t, double tan_phi) {
    const double limit = t.f_n * tan_phi, squared = t.f_t.squaredNorm();
    if (squared > limit * limit) t.f_t *= limit / std::sqrt(squared);
}

// (eq. 19): elastic-plastic increments (the birth step counts), or -k_r theta capped at use with theta the
// rotation since the contact was found (the birth step does not count). `rotation` [rad]: theta_j - theta_i
// over the step.
inline void roll(ContactState& t, const PairConstants& c, double rotation, RollingForm form, bool born) {
    const double limit = c.rolling_arm * t.f_n;
    if (form == RollingForm::incremental || !born) t.rolling -= c.k_r * rotation;
    t.moment = std::clamp(t.rolling, -limit, limit);
    if (form == RollingForm::incremental) t.rolling = t.moment;
}

// (eqs. 17 to 19) for one pair over dt [s]; false when the pair is in no contact (its memory is then gone).
inline bool advance(ContactState& t, const PairConstants& c, const PairMotion& m, double tan_phi,
                    RollingForm form, double dt) {
    SG_EXPECT(dt > 0 && c.r_i > 0 && c.r_j > 0);
    const double distance = m.d.norm(), overlap = c.r_i + c.r_j - distance;
    if (t.in_contact ? overlap < 0 : overlap <= 0) return t = ContactState{}, false;
    const Vec2 n = m.d / distance;
    const bool born = !t.in_contact;
    if (!born) turn_tangential(t, n);
    t.in_contact = true;
    t.n = n;
    t.overlap = overlap;
    t.f_n = c.k_n * overlap;
    t.f_t -= c.k_t * dt * sliding_velocity(c, m, n, overlap);
    limit_tangential(t, tan_phi);
    roll(t, c, m.rotation, form, born);
    return true;
}

// Torque of the tangential force on a grain of radius r [N m] (eq. 20); the same sign on both grains.
inline double torque(const ContactState& t, double r) {
    return -(r - 0.5 * t.overlap) * (t.n.x() * t.f_t.y() - t.n.y() * t.f_t.x());
}

}  // namespace sandgraph::dem
