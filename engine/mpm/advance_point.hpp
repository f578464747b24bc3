#pragma once
#include <cstddef>

#include "base/contracts.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

struct Advance {
    double dt = 0;   // [s]
    double pic = 0;  // share of PIC in the velocity update, the rest FLIP
};

// What a point reads from the grid: velocity [m/s], acceleration [m/s2], velocity gradient L_ij = dv_i/dx_j
// [1/s].
struct Reading {
    double vx = 0, vy = 0, ax = 0, ay = 0;
    double xx = 0, xy = 0, yx = 0, yy = 0;
};

// v_p = (1 - c)(v_p + dt a) + c v, x_p += dt v, F = F_inc F, V = V0 det F.
inline void advance_point(const Reading& r, const Advance& step, std::size_t p, Points& points) {
    SG_EXPECT(p < points.size());  // docs/how_it_works.md (eqs. 8 to 10)
    const double dt = step.dt, flip = 1 - step.pic;
    points.vx[p] = flip * (points.vx[p] + dt * r.ax) + step.pic * r.vx;
    points.vy[p] = flip * (points.vy[p] + dt * r.ay) + step.pic * r.vy;
    points.x[p] += dt * r.vx;
    points.y[p] += dt * r.vy;
    const double ixx = 1 + dt * r.xx, ixy = dt * r.xy, iyx = dt * r.yx, iyy = 1 + dt * r.yy;
    double* const inc = points.F_inc[p].data();  // column-major
    inc[0] = ixx, inc[1] = iyx, inc[2] = ixy, inc[3] = iyy;
    double* const F = points.F[p].data();
    const double xx = F[0], yx = F[1], xy = F[2], yy = F[3];
    F[0] = ixx * xx + ixy * yx;
    F[1] = iyx * xx + iyy * yx;
    F[2] = ixx * xy + ixy * yy;
    F[3] = iyx * xy + iyy * yy;
    points.volume[p] = points.volume0[p] * (F[0] * F[3] - F[1] * F[2]);
}

}  // namespace sandgraph::mpm
