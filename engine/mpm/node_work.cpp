#include "mpm/node_work.hpp"

#include <Eigen/Core>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

using Pair = Eigen::Array2d;  // x, y
using InMemory = Eigen::Map<const Pair>;

struct Powers {
    Pair damping = Pair::Zero(), gained = Pair::Zero();
};

// A node that a side holds (v = 0) has its support in `a`, which does no work. Nodes that gave all they had
// to others, images and followers, have no mass and no force.
void add_row(const Field& field, std::size_t first, std::size_t last, const GridStep& step, Powers& sum) {
    const Pair gravity = step.gravity.array();
    const double half_dt = 0.5 * step.dt, scaling = step.mass_scaling;
    const Motion* motion = field.motion.data() + first;
    Powers row;
    for (const Node *n = field.nodes.data() + first, *end = n + (last - first + 1); n < end; ++n, ++motion) {
        if (n->mass == 0) continue;
        const InMemory v(&motion->vx), a(&motion->ax), force(&n->fx);
        const Pair kept = (scaling * n->mass) * a;
        row.damping += (force + n->mass * gravity - kept) * v;
        row.gained += kept * (v - half_dt * a);
    }
    sum.damping += row.damping, sum.gained += row.gained;
}

}  // namespace

NodeWork& NodeWork::operator+=(const NodeWork& other) {
    damping += other.damping, gained += other.gained;
    return *this;
}

NodeWork node_work(const GridStep& step, const Grid& grid) {  // docs/how_it_works.md (eqs. 12a to 12b)
    SG_EXPECT(step.dt > 0 && step.mass_scaling > 0);
    Powers sum;
    const GridShape& s = grid.shape;
    for (const Field& field : grid.fields) {
        const NodeBox& b = field.box;
        for (int j = b.j0; !b.empty() && j <= b.j1; ++j)
            add_row(field, s.index(b.i0, j), s.index(b.i1, j), step, sum);
    }
    return {sum.damping.sum() * step.dt, sum.gained.sum() * step.dt};
}

}  // namespace sandgraph::mpm
