#include "mpm/transfer_kernel.hpp"

#include <algorithm>

#include "base/contracts.hpp"
#include "mpm/advance_point.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mpm/transfer_kernel.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h
#include "hwy/highway.h"
#include "mpm/gimp-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::mpm::HWY_NAMESPACE {

struct Weighted {
    AxisWeights x, y;
};

// Short blocks repeat their last point; its lanes are computed and not used.
HWY_INLINE void weigh_points(std::span<const std::int32_t> ids, const Points& points, const GridShape& shape,
                             Weighted& w) {
    alignas(64) double x[block], y[block];
    for (std::size_t k = 0; k < block; ++k) {
        const auto p = static_cast<std::size_t>(ids[std::min(k, ids.size() - 1)]);
        x[k] = points.x[p];
        y[k] = points.y[p];
    }
    weigh_block(x, {shape.x0, points.half, shape.cell}, w.x);
    weigh_block(y, {shape.y0, points.half, shape.cell}, w.y);
}

HWY_INLINE std::size_t first_node(const Weighted& w, const GridShape& shape, std::size_t k) {
    return shape.index(static_cast<int>(w.x.base[k]), static_cast<int>(w.y.base[k]));
}

// A point's share of a node is S q + dS/dx gx + dS/dy gy; lanes as in Node.
struct alignas(64) Load {
    double q[8], gx[8], gy[8];
};

// Momentum S m v and internal force -V sigma grad S: docs/how_it_works.md (eq. 3).
HWY_INLINE void load_point(const Points& points, std::span<const Stress> stress, std::size_t p, Load& load) {
    const double m = points.mass[p], V = points.volume[p];
    const Stress& s = stress[p];
    load.q[0] = m, load.q[1] = m * points.vx[p], load.q[2] = m * points.vy[p];
    load.q[5] = m * points.x[p], load.q[6] = m * points.y[p], load.q[7] = m;
    load.gx[3] = -V * s.xx, load.gx[4] = -V * s.xy;
    load.gy[3] = load.gx[4], load.gy[4] = -V * s.yy;
}

HWY_INLINE void scatter_point(const Weighted& w, std::size_t k, const Load& load, const GridShape& shape,
                              Node* HWY_RESTRICT nodes) {
    const auto q = Record<8>::load(load.q), gx = Record<8>::load(load.gx), gy = Record<8>::load(load.gy);
    Node* row = nodes + first_node(w, shape, k);
    for (int j = 0; j < 3; ++j, row += shape.stride()) {
        const auto value = Record<8>::zero().plus(w.y.S[j][k], q).plus(w.y.dS[j][k], gy);
        const auto slope = Record<8>::zero().plus(w.y.S[j][k], gx);
        for (int i = 0; i < 3; ++i) {
            double* const node = &row[i].mass;
            Record<8>::load(node).plus(w.x.S[i][k], value).plus(w.x.dS[i][k], slope).store(node);
        }
    }
}

void Scatter(std::span<const std::int32_t> ids, const Points& points, std::span<const Stress> stress,
             const GridShape& shape, Node* nodes) {
    Load loads[block] = {};
    Weighted w;
    for (std::size_t start = 0; start < ids.size(); start += block) {
        const auto part = ids.subspan(start, std::min(block, ids.size() - start));
        weigh_points(part, points, shape, w);
        for (std::size_t k = 0; k < part.size(); ++k)
            load_point(points, stress, static_cast<std::size_t>(part[k]), loads[k]);
        for (std::size_t k = 0; k < part.size(); ++k) scatter_point(w, k, loads[k], shape, nodes);
    }
}

// Motion summed with S, dS/dx and dS/dy.
struct alignas(64) Sums {
    double value[4], dx[4], dy[4];
};

HWY_INLINE void gather_point(const Weighted& w, std::size_t k, const GridShape& shape,
                             const Motion* HWY_RESTRICT motion, Sums& sums) {
    const Motion* row = motion + first_node(w, shape, k);
    auto value = Record<4>::zero(), dx = Record<4>::zero(), dy = Record<4>::zero();
    for (int j = 0; j < 3; ++j, row += shape.stride()) {
        auto along = Record<4>::zero(), slope = Record<4>::zero();
        for (int i = 0; i < 3; ++i) {
            const auto node = Record<4>::load(&row[i].vx);
            along = along.plus(w.x.S[i][k], node);
            slope = slope.plus(w.x.dS[i][k], node);
        }
        value = value.plus(w.y.S[j][k], along);
        dx = dx.plus(w.y.S[j][k], slope);
        dy = dy.plus(w.y.dS[j][k], along);
    }
    value.store(sums.value), dx.store(sums.dx), dy.store(sums.dy);
}

HWY_INLINE Reading reading(const Sums& s) {
    return {s.value[0], s.value[1], s.value[2], s.value[3], s.dx[0], s.dy[0], s.dx[1], s.dy[1]};
}

void Gather(std::span<const std::int32_t> ids, const GridShape& shape, const Motion* motion,
            const Advance& step, Points& points) {
    Weighted w;
    Sums sums[block];
    for (std::size_t start = 0; start < ids.size(); start += block) {
        const auto part = ids.subspan(start, std::min(block, ids.size() - start));
        weigh_points(part, points, shape, w);
        for (std::size_t k = 0; k < part.size(); ++k) gather_point(w, k, shape, motion, sums[k]);
        for (std::size_t k = 0; k < part.size(); ++k)
            advance_point(reading(sums[k]), step, static_cast<std::size_t>(part[k]), points);
    }
}

}  // namespace sandgraph::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sandgraph::mpm {

HWY_EXPORT(Scatter);
HWY_EXPORT(Gather);

void scatter(std::span<const std::int32_t> ids, const Points& points, std::span<const Stress> stress,
             const GridShape& shape, Node* nodes) {
    SG_EXPECT(stress.size() == points.size());
    SG_EXPECT(nodes != nullptr && all_below(ids, points.size()));
    SG_EXPECT(points.half <= 0.5 * shape.cell * (1 + 1e-12));
    HWY_DYNAMIC_DISPATCH(Scatter)(ids, points, stress, shape, nodes);
}

void gather(std::span<const std::int32_t> ids, const GridShape& shape, const Motion* motion,
            const Advance& advance, Points& points) {
    SG_EXPECT(motion != nullptr && all_below(ids, points.size()));
    HWY_DYNAMIC_DISPATCH(Gather)(ids, shape, motion, advance, points);
}

}  // namespace sandgraph::mpm
#endif
