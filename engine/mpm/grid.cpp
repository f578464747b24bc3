#include "mpm/grid.hpp"

#include <algorithm>

#include "base/contracts.hpp"

namespace sandgraph::mpm {

Grid::Grid(const GridShape& grid_shape) : shape(grid_shape) {
    SG_EXPECT(shape.cell > 0 && shape.nx > 0 && shape.ny > 0);
    fields[0].nodes.resize(shape.size());
    fields[0].motion.resize(shape.size());
    fields[0].box = whole(shape);
}

void clear(Grid& grid) {
    for (Field& field : grid.fields) {
        const NodeBox& box = field.box;
        for (int j = box.j0; j <= box.j1 && !box.empty(); ++j) {
            const auto first = field.nodes.begin() + static_cast<std::ptrdiff_t>(grid.shape.index(box.i0, j));
            std::fill(first, first + (box.i1 - box.i0 + 1), Node{});
        }
    }
}

}  // namespace sandgraph::mpm
