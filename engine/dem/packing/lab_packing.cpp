#include "dem/packing/lab_packing.hpp"

#include "dem/stretch.hpp"

namespace sandgraph::dem {
namespace {

void turn(const Mat2& R, std::vector<double>& x, std::vector<double>& y) {
    for (std::size_t k = 0; k < x.size(); ++k) {
        const Vec2 turned = R * Vec2(x[k], y[k]);
        x[k] = turned.x(), y[k] = turned.y();
    }
}

}  // namespace

// Tangential forces and moments are scalars of the contact and turn with it.
Packing lab_packing(const Rve& rve) {
    Packing packing = to_packing(rve.packing());
    const Mat2 R = rotation(rve.angle());
    packing.H = R * packing.H, packing.L = turned(packing.L, rve.angle());
    turn(R, packing.x, packing.y), turn(R, packing.vx, packing.vy);
    return packing;
}

}  // namespace sandgraph::dem
