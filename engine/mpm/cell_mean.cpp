#include "mpm/cell_mean.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "mpm/parallel_bands.hpp"

namespace sandgraph::mpm {
namespace {

// First cell that the domain [c - half, c + half] reaches into and its share in it; the rest is in the next.
struct Along {
    int first = 0;
    double share = 1;
};
Along along(double c, double half, double origin, double cell) {
    const double low = (c - half - origin) / cell, width = 2 * half / cell;
    const double first = std::floor(low);
    return {static_cast<int>(first), std::min(1.0, (first + 1 - low) / width)};
}

// F_inc = I + H; F and the volume follow.
void set_increment(Points& points, std::size_t p, const std::array<double, 4>& H) {
    const Mat2 before = points.F_inc[p];
    Mat2 inc;
    inc << 1 + H[0], H[1], H[2], 1 + H[3];
    const double per_det = 1 / (before(0, 0) * before(1, 1) - before(0, 1) * before(1, 0));
    Mat2 inverse;
    inverse << before(1, 1) * per_det, -before(0, 1) * per_det, -before(1, 0) * per_det,
        before(0, 0) * per_det;
    const Mat2 F = inc * (inverse * points.F[p]);
    points.F_inc[p] = inc;
    points.F[p] = F;
    points.volume[p] = points.volume0[p] * (F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0));
}

}  // namespace

CellMean::CellMean(double keep) : keep_(keep) { SG_EXPECT(keep > 0 && keep <= 1); }

template <class F>
void CellMean::each_cell(std::size_t p, F f) const {
    const Weight& w = weight_[p];
    const std::size_t at[4] = {w.at, w.at + 1, w.at + stride_, w.at + stride_ + 1};
    for (std::size_t k = 0; k < 4; ++k)
        if (w.share[k] > 0) f(at[k] + w.across[k] * cells_, w.share[k]);
}

void CellMean::weigh(const Points& points, const Order& order, const Grid& grid,
                     const Boundaries& boundaries) {
    const GridShape& s = grid.shape;
    shape_ = s, boundaries_ = boundaries;
    stride_ = static_cast<std::size_t>(s.stride()), cells_ = s.size();
    weight_.resize(points.size());
    volume_ = points.volume;
    for_points(order, [&](std::size_t p) {
        const double x = points.x[p], y = points.y[p];
        const Along i = along(x, points.half, s.x0, s.cell), j = along(y, points.half, s.y0, s.cell);
        Weight w{s.index(i.first, j.first), {}, {}};
        w.share = {i.share * j.share, (1 - i.share) * j.share, i.share * (1 - j.share),
                   (1 - i.share) * (1 - j.share)};
        for (int k = 0; k < 4 && order.is_near[p]; ++k)
            w.across[static_cast<std::size_t>(k)] =
                grid.parts(x, y, s.x(i.first + k % 2) + 0.5 * s.cell, s.y(j.first + k / 2) + 0.5 * s.cell);
        weight_[p] = w;
    });
    measure_.assign(2 * cells_, 0.0);
    value_.resize(points.size());
    add_up(order, true);
}

void CellMean::add_point(std::size_t p, bool volumes) {
    const double V = volume_[p];
    each_cell(p, [&](std::size_t c, double share) {
        if (volumes)
            measure_[c] += share * V;
        else
            for (std::size_t k = 0; k < 4; ++k) sum_[c][k] += share * V * value_[p][k];
    });
}

// Bands of one colour share no cell, as they share no node: the order of every sum is fixed.
void CellMean::add_up(const Order& order, bool volumes) {
    if (!volumes) sum_.assign(2 * cells_, Four{});
    const auto add = [&](std::span<const std::int32_t> ids) {
        for (const auto id : ids) add_point(static_cast<std::size_t>(id), volumes);
    };
    for_bands(order, 0, 2, add);
    for_bands(order, 1, 2, add);
    add(order.near);
    add_images(volumes);
}

// What lies in a cell behind a mirror plane belongs to the cell before it; the mirror turns the sign of the
// terms off the diagonal. A cell that the plane halves is its own image: they cancel.
void CellMean::add_image(std::size_t image, std::size_t original) {
    for (std::size_t side = 0; side < 2; ++side, image += cells_, original += cells_) {
        Four &a = sum_[image], &b = sum_[original];
        if (image != original) {
            b = {a[0] + b[0], b[1] - a[1], b[2] - a[2], a[3] + b[3]};
            a = {b[0], -b[1], -b[2], b[3]};
        } else {
            b[1] = b[2] = 0;
        }
    }
}

void CellMean::add_images(bool volumes) {
    const int ox = boundaries_.between_x ? 0 : -1, oy = boundaries_.between_y ? 0 : -1;
    const auto pair = [&](std::size_t image, std::size_t original) {
        if (!volumes) return add_image(image, original);
        for (std::size_t side = 0; side < 2 && image != original; ++side, image += cells_, original += cells_)
            measure_[image] = measure_[original] += measure_[image];
    };
    for (int j = -1; j <= shape_.ny; ++j) {
        if (boundaries_.left == Side::mirror) pair(shape_.index(ox, j), shape_.index(0, j));
        if (boundaries_.right == Side::mirror)
            pair(shape_.index(shape_.nx - 1 - ox, j), shape_.index(shape_.nx - 1, j));
    }
    for (int i = -1; i <= shape_.nx; ++i) {
        if (boundaries_.bottom == Side::mirror) pair(shape_.index(i, oy), shape_.index(i, 0));
        if (boundaries_.top == Side::mirror)
            pair(shape_.index(i, shape_.ny - 1 - oy), shape_.index(i, shape_.ny - 1));
    }
}

CellMean::Four CellMean::mean(std::size_t p) const {
    Four m{};
    each_cell(p, [&](std::size_t c, double share) {
        for (std::size_t k = 0; k < 4; ++k) m[k] += share / measure_[c] * sum_[c][k];
    });
    for (std::size_t k = 0; k < 4; ++k) m[k] += keep_ * (value_[p][k] - m[k]);
    return m;
}

const std::vector<Stress>& CellMean::stress(std::span<const Stress> stress, const Order& order) {
    SG_EXPECT(weight_.size() == stress.size());
    stress_.resize(stress.size());
    for_points(order, [&](std::size_t p) {
        const Stress& s = stress[p];
        value_[p] = {s.xx, s.xy, s.xy, s.yy};
    });
    add_up(order, false);
    for_points(order, [&](std::size_t p) {
        const Four m = mean(p);
        stress_[p] = {m[0], m[3], m[1]};
    });
    return stress_;
}

void CellMean::strain(const Order& order, Points& points) {
    SG_EXPECT(weight_.size() == points.size());
    for_points(order, [&](std::size_t p) {
        const Mat2& F = points.F_inc[p];
        value_[p] = {F(0, 0) - 1, F(0, 1), F(1, 0), F(1, 1) - 1};
    });
    add_up(order, false);
    for_points(order, [&](std::size_t p) { set_increment(points, p, mean(p)); });
}

}  // namespace sandgraph::mpm
