#pragma once
#include <cstdint>
#include <vector>

#include "base/archive.hpp"
#include "base/tensor.hpp"

namespace sandgraph::mpm {

// Material points by id (ids never change; other code owns slots by id). Per metre out of plane.
// Every domain is the square [x - half, x + half] x [y - half, y + half] (uniform GIMP).
struct Points {
    double half = 0;              // half side of a domain, lp [m]; at most half a cell
    std::vector<double> x, y;     // [m]
    std::vector<double> vx, vy;   // [m/s]
    std::vector<double> mass;     // [kg/m]; inertia is mass times the mass scaling of the grid update
    std::vector<double> volume0;  // initial volume [m2]
    std::vector<double> volume;   // V = V0 det F [m2]
    std::vector<Mat2> F;          // deformation gradient
    std::vector<Mat2> F_inc;      // I + dt L of the last step; F = F_inc F_old
    std::vector<Stress>
        stress;  // Cauchy [Pa], tension positive; written by the material law between two steps
    std::vector<std::int32_t> row;      // depth row, 0 at the surface
    std::vector<std::int32_t> surface;  // ids of the points that carry the surcharge
    std::vector<double> bare;           // of each of them: the share of its edge that no body stands on
    // Which half of the domain is no ground from the start since a body's end cuts it: -1 left, 1 right, 0
    // none. Those are half points.
    std::vector<std::int32_t> cut;

    std::size_t size() const { return x.size(); }
};

// Of a point's domain, what is ground of the model: 1, or a half of one that stands on a mirror plane or at
// the end of a body.
inline double share(const Points& points, std::size_t p) {
    return points.volume0[p] / (4 * points.half * points.half);
}

// Points at rest and unstrained; x, y set by the caller.
void resize(Points& points, std::size_t count);
void archive(Archive& a, Points& points);

}  // namespace sandgraph::mpm
