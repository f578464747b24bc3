#include "results/drag.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::results {

Drag drag_at(std::span<const io::LoadRow> rows, double d_over_B, double half_width) {
    SG_EXPECT(half_width > 0);
    Drag sum;
    double weight = 0;
    for (const io::LoadRow& row : rows) {
        if (std::fabs(row.d_over_B - d_over_B) > half_width || !(row.load > 0)) continue;
        weight += row.load;
        sum.damping += row.load * row.damping_share;
        sum.pic += row.load * row.pic_share;
        sum.inertia += row.load * row.inertia_share;
    }
    if (weight == 0) return {};
    return {sum.damping / weight, sum.pic / weight, sum.inertia / weight};
}

double largest_drag(std::span<const io::LoadRow> rows, double from, double half_width) {
    double largest = 0;
    for (const io::LoadRow& row : rows)
        if (row.d_over_B >= from) largest = std::max(largest, drag_at(rows, row.d_over_B, half_width).sum());
    return largest;
}

}  // namespace sandgraph::results
