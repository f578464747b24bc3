#include "mpm/length_mean.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "mpm/parallel_bands.hpp"
#include "mpm/stencil.hpp"

namespace sandgraph::mpm {
namespace {

constexpr double kLargestShare = 0.2;  // at 0.25 the shortest wave would only change its sign in a pass
constexpr int kRows = 16, kSerialNodes = 4000;

template <class F>
void for_rows(const NodeBox& box, F f) {
    const auto run = [&](int from, int to) {
        for (int j = from; j < to; ++j) f(j);
    };
    if (box.empty()) return;
    if ((box.j1 - box.j0) * (box.i1 - box.i0) < kSerialNodes) return run(box.j0, box.j1 + 1);
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(box.j0, box.j1 + 1, kRows),
                              [&](const auto& r) { run(r.begin(), r.end()); });
}

// Sums at nodes over the points: bands of one colour share no node, so that their order is fixed.
template <class F>
void for_bands_in_turn(const Order& order, F add) {
    const auto all = [&](std::span<const std::int32_t> ids) {
        for (const auto id : ids) add(static_cast<std::size_t>(id));
    };
    for_bands(order, 0, 2, all);
    for_bands(order, 1, 2, all);
    all(order.near);
}

}  // namespace

// Each way between points and nodes spreads by the hat's cell^2/6 and the domain's half^2/3, a pass by
// 2 share cell^2.
LengthMean::LengthMean(double variance, double half, double cell) {  // docs/how_it_works.md (eq. 7c)
    SG_EXPECT(cell > 0 && half > 0 && variance >= 0);
    const double rest = (variance - cell * cell / 3 - 2 * half * half / 3) / (cell * cell);
    if (rest <= 0) return;
    passes_ = static_cast<int>(std::ceil(rest / (2 * kLargestShare)));
    share_ = rest / (2 * passes_);
}

// f(weight, value) for the nine nodes of a point.
template <class Value>
void LengthMean::each_node(const Weight& w, std::vector<Value> Nodes::*values, auto f) {
    std::size_t row = w.first;
    for (unsigned j = 0; j < 3; ++j, row += static_cast<std::size_t>(shape_.stride()))
        for (unsigned i = 0; i < 3; ++i)
            f(w.x[i] * w.y[j], (nodes_[(w.across >> (3 * j + i)) & 1u].*values)[row + i]);
}

void LengthMean::weigh_point(const Points& points, std::size_t p, bool near, const Grid& grid) {
    const GridShape& s = grid.shape;
    const double x = points.x[p], y = points.y[p], half = points.half;
    const Weights along = average(x - half - s.x0, x + half - s.x0, s.cell),
                  up = average(y - half - s.y0, y + half - s.y0, s.cell);
    weight_[p] = {s.index(along.base, up.base), along.S, up.S,
                  near ? stencil(grid, along, up, x, y).across : 0u};
}

// Images behind the sides take no part in the passes.
void LengthMean::start(Nodes& nodes, const Field& field) const {
    const NodeBox& b = field.box;
    const std::size_t size = b.empty() ? 0 : shape_.size();
    for (auto* values : {&nodes.volume, &nodes.per_volume, &nodes.right, &nodes.up}) values->assign(size, 0);
    nodes.value.resize(size), nodes.next.assign(size, Deviator::Zero());
    nodes.box = b;
    if (b.empty()) return;
    nodes.box = {std::max(b.i0, 0), std::max(b.j0, 0), std::min(b.i1, shape_.nx), std::min(b.j1, shape_.ny)};
}

void LengthMean::weigh(const Points& points, const Order& order, const Grid& grid) {
    SG_EXPECT(!order.stale);
    shape_ = grid.shape, volume_ = points.volume;
    weight_.resize(points.size());
    for (std::size_t k = 0; k < 2; ++k) start(nodes_[k], grid.fields[k]);
    for_points(order, [&](std::size_t p) { weigh_point(points, p, order.is_near[p] != 0, grid); });
    for_bands_in_turn(order, [&](std::size_t p) {
        each_node(weight_[p], &Nodes::volume, [V = volume_[p]](double S, double& v) { v += S * V; });
    });
    for (Nodes& nodes : nodes_) link(nodes);
    unlink(grid);
}

void LengthMean::link(Nodes& n) const {
    const auto stride = static_cast<std::size_t>(shape_.stride());
    for (std::size_t at = 0; at < n.volume.size(); ++at)
        n.per_volume[at] = n.volume[at] > 0 ? 1 / n.volume[at] : 0;
    for_rows(n.box, [&](int j) {
        for (int i = n.box.i0; i <= n.box.i1; ++i) {
            const std::size_t at = shape_.index(i, j);
            if (i < n.box.i1) n.right[at] = share_ * std::min(n.volume[at], n.volume[at + 1]);
            if (j < n.box.j1) n.up[at] = share_ * std::min(n.volume[at], n.volume[at + stride]);
        }
    });
}

// Two nodes on the two sides of a thin body have each the other's side as their second field.
void LengthMean::unlink(const Grid& grid) {
    const NodeBox& b = nodes_[1].box;
    for (int j = b.j0; !b.empty() && j <= b.j1; ++j)
        for (int i = b.i0; i <= b.i1; ++i) {
            const std::size_t at = shape_.index(i, j);
            const double x = shape_.x(i), y = shape_.y(j);
            if (grid.parts(x, y, shape_.x(i + 1), y)) nodes_[0].right[at] = nodes_[1].right[at] = 0;
            if (grid.parts(x, y, x, shape_.y(j + 1))) nodes_[0].up[at] = nodes_[1].up[at] = 0;
        }
}

void LengthMean::smooth_row(Nodes& n, int j) const {
    const auto stride = static_cast<std::size_t>(shape_.stride());
    const std::vector<Deviator>& v = n.value;
    for (std::size_t at = shape_.index(n.box.i0, j), last = shape_.index(n.box.i1, j); at <= last; ++at) {
        const Deviator own = v[at];
        const Deviator sides = n.right[at] * (v[at + 1] - own) + n.right[at - 1] * (v[at - 1] - own);
        const Deviator levels =
            n.up[at] * (v[at + stride] - own) + n.up[at - stride] * (v[at - stride] - own);
        n.next[at] = own + n.per_volume[at] * (sides + levels);
    }
}

void LengthMean::smooth(Nodes& n) const {
    for (int k = 0; k < passes_; ++k) {
        for_rows(n.box, [&](int j) { smooth_row(n, j); });
        n.value.swap(n.next);
    }
}

void LengthMean::mean(const std::vector<Deviator>& field, const Order& order, std::vector<Deviator>& out) {
    SG_EXPECT(field.size() == weight_.size());
    for (Nodes& n : nodes_) std::ranges::fill(n.value, Deviator::Zero());
    for_bands_in_turn(order, [&](std::size_t p) {
        const Deviator f = volume_[p] * field[p];
        each_node(weight_[p], &Nodes::value, [&](double S, Deviator& v) { v += S * f; });
    });
    for (Nodes& n : nodes_) {
        for (std::size_t at = 0; at < n.value.size(); ++at) n.value[at] *= n.per_volume[at];
        n.next = n.value;  // what takes no part in the passes
        smooth(n);
    }
    out.resize(field.size());
    for_points(order, [&](std::size_t p) {
        Deviator sum = Deviator::Zero();
        each_node(weight_[p], &Nodes::value, [&](double S, const Deviator& v) { sum += S * v; });
        out[p] = sum;
    });
}

}  // namespace sandgraph::mpm
