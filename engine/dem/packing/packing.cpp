#include "dem/packing/packing.hpp"

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "dem/reference/pairs.hpp"

namespace sandgraph::dem {
namespace {

constexpr double largest_overlap = 0.5;  // of the smaller radius
constexpr double smallest_sine = 1e-4;   // between the periods
constexpr double longest = 1e6;          // period over the other one
constexpr double farthest = 1e4;         // cells from the origin; image offsets are 16-bit

InputError::Where grain_line(const PackingSource& s, std::size_t g) {
    return {s.file, g < s.grain_lines.size() ? s.grain_lines[g] : 0};
}

void check_cell(const Packing& p, const PackingSource& s) {
    const InputError::Where where{s.file, s.cell_line};
    if (!p.H.allFinite())
        throw InputError(where, "cell is not finite", "NaN or infinity in H", "give four numbers in m");
    const double a = p.H.col(0).norm(), b = p.H.col(1).norm(), sides = a * b;
    if (!(std::abs(p.area()) > smallest_sine * sides))
        throw InputError(where, "cell is singular", fmt::format("det H = {:g} m2", p.area()),
                         "give two periods that are not parallel");
    if (std::max(a, b) > longest * std::min(a, b))
        throw InputError(where, "cell is too long", fmt::format("periods of {:g} and {:g} m", a, b),
                         "check the units of H");
    if (p.area() < 0)
        throw InputError(where, "cell is inverted", fmt::format("det H = {:g} m2 < 0", p.area()),
                         "swap its columns");
}

void check_grain(const Packing& p, std::size_t g, const Mat2& inverse, const PackingSource& s) {
    if (!std::isfinite(p.r[g]) || p.r[g] <= 0)
        throw InputError(grain_line(s, g), fmt::format("radius {:g} m", p.r[g]),
                         "a radius must be positive and finite", "give it in m, e.g. 0.005");
    const Vec2 x(p.x[g], p.y[g]);
    if (!x.allFinite())
        throw InputError(grain_line(s, g), "position is not finite", "NaN or infinity", "give x and y in m");
    if ((inverse * x).cwiseAbs().maxCoeff() > farthest)
        throw InputError(grain_line(s, g), fmt::format("centre ({:g}, {:g}) m is far outside", x.x(), x.y()),
                         fmt::format("more than {:g} cells away", farthest), "wrap it into the cell");
}

void check_size(const Packing& p, const PackingSource& s) {
    const auto [least, most] = std::minmax_element(p.r.begin(), p.r.end());
    const double r_max = *most;
    if (!(r_max <= widest_grading * *least))
        throw InputError(grain_line(s, static_cast<std::size_t>(least - p.r.begin())),
                         fmt::format("radius {:g} m beside one of {:g} m", *least, r_max),
                         fmt::format("more than {:g} times smaller", widest_grading), "check the units of r");
    const double shortest = reduce_lattice(p.H).basis.col(0).norm();
    if (shortest < (2 - largest_overlap) * r_max)
        throw InputError({s.file, s.cell_line}, "cell is smaller than a grain",
                         fmt::format("shortest period {:g} m, largest radius {:g} m", shortest, r_max),
                         "enlarge the cell or check the units");
}

void check_overlaps(const Packing& p, const PackingSource& s) {
    std::vector<Vec2> x;
    for (std::size_t g = 0; g < p.size(); ++g) x.emplace_back(p.x[g], p.y[g]);
    for (const PairKey& k : near_pairs(x, p.r, p.H, 0)) {
        const Vec2 d = x[k.j] + p.H * Vec2(k.cell_x, k.cell_y) - x[k.i];
        const double share = (p.r[k.i] + p.r[k.j] - d.norm()) / std::min(p.r[k.i], p.r[k.j]);
        if (share > largest_overlap)
            throw InputError(grain_line(s, static_cast<std::size_t>(k.j)),
                             fmt::format("grains {} and {} overlap by {:.0f} % of the smaller radius", k.i,
                                         k.j, 100 * share),
                             fmt::format("more than {:.0f} % is no contact (image {}, {})",
                                         100 * largest_overlap, k.cell_x, k.cell_y),
                             "check cell, positions and radii, or relax the packing");
    }
}

}  // namespace

double porosity(const Packing& packing) {
    double solid = 0;
    for (double r : packing.r) solid += std::numbers::pi * r * r;
    return 1 - solid / packing.area();
}

void check_packing(const Packing& p, const PackingSource& s) {
    SG_EXPECT(p.y.size() == p.size() && p.r.size() == p.size());
    if (p.size() == 0)
        throw InputError({s.file, 0}, "no grains", "a packing needs at least one", "add rows id,x,y,r");
    check_cell(p, s);
    const Mat2 inverse = p.H.inverse();
    for (std::size_t g = 0; g < p.size(); ++g) check_grain(p, g, inverse, s);
    check_size(p, s);
    check_overlaps(p, s);
}

}  // namespace sandgraph::dem
