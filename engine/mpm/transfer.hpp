#pragma once
#include "mpm/grid.hpp"
#include "mpm/order.hpp"
#include "mpm/points.hpp"
#include "mpm/transfer_kernel.hpp"

namespace sandgraph::mpm {

// Clears the grid and adds what the points bring, with uniform GIMP weights S_ip (Bardenhagen & Kober 2004):
//   m_i = sum_p S_ip m_p,  p_i = sum_p S_ip m_p v_p,  f_i = -sum_p V_p sigma_p . grad S_ip.
// `order` must be fresh. Sums come in the same order at any thread count. `stress` [Pa] by point id: the
// points' own, or the one that reduced integration takes for it (cell_mean.hpp).
void points_to_grid(const Points& points, std::span<const Stress> stress, const Order& order, Grid& grid);
inline void points_to_grid(const Points& points, const Order& order, Grid& grid) {
    points_to_grid(points, points.stress, order, grid);
}

// What the caller must look at: with `outside` > 0 the next refresh of the order throws.
struct Status {
    int outside = 0;          // points that left the grid
    std::int32_t first = -1;  // the smallest id among them
    bool good() const { return outside == 0; }
};

// v_p = (1 - c)(v_p + dt sum_i S_ip a_i) + c sum_i S_ip v_i  (FLIP with a share c of PIC; v_i after the
// update), x_p += dt sum_i S_ip v_i,  F_inc = I + dt sum_i v_i (x) grad S_ip,  F = F_inc F,  V = V0 det F.
// Strain from v_i itself, not from point velocities projected once more (MUSL): that would keep 0.993 instead
// of 0.906 of the energy of two colliding disks of 8 cells, but a plate's peak load is the same with 4 points
// a cell and 1.5 % farther from the fine grid's with 1, for a second pass over the points.
Status grid_to_points(const Grid& grid, const Advance& advance, Order& order, Points& points);

}  // namespace sandgraph::mpm
