#include "mpm/surcharge.hpp"

#include "base/contracts.hpp"
#include "mpm/reach.hpp"

namespace sandgraph::mpm {

void add_surcharge(double q, const Points& points, Grid& grid) {
    SG_EXPECT(q >= 0 && all_below(points.surface, points.size()));
    const GridShape& s = grid.shape;
    const double half = points.half;
    for (const auto id : points.surface) {
        const auto p = static_cast<std::size_t>(id);
        const double x = points.x[p] - s.x0, y = points.y[p] - s.y0;
        const Reach top =
            reach(grid, average(x - half, x + half, s.cell), at(y + half, s.cell), points.x[p], points.y[p]);
        spread(grid, top, 0, -q * 2 * half);
    }
}

}  // namespace sandgraph::mpm
