#pragma once
#include "mpm/grid.hpp"
#include "mpm/order.hpp"
#include "mpm/points.hpp"

namespace sandgraph::mpm {

// Clears the grid and adds what the points bring, with uniform GIMP weights S_ip (Bardenhagen & Kober 2004):
//   m_i = sum_p S_ip m_p,  p_i = sum_p S_ip m_p v_p,  f_i = -sum_p V_p sigma_p . grad S_ip.
// `order` must be fresh. Sums come in the same order at any thread count.
void points_to_grid(const Points& points, const Order& order, Grid& grid);

}  // namespace sandgraph::mpm
