#include "dem/mixed/packing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/contracts.hpp"

namespace sandgraph::dem {
namespace {

constexpr double kPeriod = 4294967296.0;  // units of a coordinate
constexpr int kLargest = 65000;           // pairs address grains with 16 bits

std::int32_t units(double share) {
    const auto whole = static_cast<std::int64_t>(std::llround((share - std::floor(share)) * kPeriod));
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(whole));
}

void load_mass(const Packing& p, const Material& m, int g, MixedState& s) {
    const double mass = m.density * m.depth * std::numbers::pi * p.r[g] * p.r[g];
    s.radius[g] = float(p.r[g]);
    s.inverse_mass[g] = float(1 / mass), s.inverse_inertia[g] = float(2 / (mass * p.r[g] * p.r[g]));
}

void place_grain(const Packing& p, const Mat2& inverse, int g, MixedPacking& out) {
    const Vec2 x(p.x[g], p.y[g]), share = inverse * x;
    const Vec2 v = p.vx.empty() ? Vec2(0, 0) : Vec2(p.vx[g], p.vy[g]), u = v - p.L * x;
    out.x[g] = units(share.x()), out.y[g] = units(share.y());
    out.x_rest[g] = out.y_rest[g] = 0;
    out.u[g] = float(u.x()), out.v[g] = float(u.y());
    out.w[g] = p.spin.empty() ? 0.0f : float(p.spin[g]);
}

}  // namespace

std::size_t MixedPacking::bytes() const {
    return 4 * (x.capacity() + y.capacity() + x_rest.capacity() + y_rest.capacity() +
                inverse_allowance2.capacity() + u.capacity() + v.capacity() + w.capacity()) +
           rows.capacity() + 2 * (partner.capacity() + loose_first.capacity()) +
           4 * (tangential.capacity() + moment.capacity() + loose_gap.capacity());
}

void resize_grains(MixedState& s, int n) {
    SG_EXPECT(n >= 0 && n <= kLargest);
    const std::size_t room = room_for(n);
    s.packing.grains = n, s.grains_of.reset();
    for (auto* a : {&s.packing.x, &s.packing.y}) a->assign(room, 0);
    for (auto* a : {&s.packing.x_rest, &s.packing.y_rest, &s.packing.u, &s.packing.v, &s.packing.w,
                    &s.packing.inverse_allowance2, &s.radius, &s.inverse_mass, &s.inverse_inertia,
                    &s.fx_on_first, &s.fy_on_first, &s.torque_on_first})
        a->assign(room, 0);
    s.record.assign(8 * room, 0), s.on_second.assign(4 * room, 0);
}

void load(const Packing& p, const Material& material, MixedState& s, MixedList& list) {
    SG_EXPECT(p.size() > 0 && p.y.size() == p.size() && p.r.size() == p.size());
    SG_EXPECT(p.vx.empty() || (p.vx.size() == p.size() && p.vy.size() == p.size()));
    if (p.size() > kLargest) throw std::invalid_argument("the kernel takes at most 65,000 grains a packing");
    resize_grains(s, static_cast<int>(p.size()));
    s.radius_max = *std::max_element(p.r.begin(), p.r.end());
    for (int g = 0; g < s.packing.grains; ++g) load_mass(p, material, g, s);
    place(p, s, list);
}

void place(const Packing& p, MixedState& s, MixedList& list) {
    SG_EXPECT(static_cast<std::size_t>(s.packing.grains) == p.size() && s.radius_max > 0);
    if (too_thin(p.H * reduce_cell(p.H).U.cast<double>(), s.radius_max))
        throw std::invalid_argument("the mixed kernel takes no packing of so few grains");
    const Mat2 inverse = p.H.inverse();
    for (int g = 0; g < s.packing.grains; ++g) place_grain(p, inverse, g, s.packing);
    s.packing.H = p.H, s.packing.L = p.L;
    list.relist(s, p.contacts);
}

Packing to_packing(const MixedPacking& p, const std::vector<double>& radii) {
    SG_EXPECT(radii.size() == static_cast<std::size_t>(p.grains));
    Packing out;
    out.H = p.H, out.L = p.L, out.r = radii;
    for (int g = 0; g < p.grains; ++g) {
        const Vec2 x = centre(p, g), v = Vec2(p.u[g], p.v[g]) + p.L * x;
        out.x.push_back(x.x()), out.y.push_back(x.y());
        out.vx.push_back(v.x()), out.vy.push_back(v.y()), out.spin.push_back(p.w[g]);
    }
    contact_history(p, out.contacts);
    return out;
}

bool too_thin(const Mat2& H, double radius_max) {
    const double longest = std::max(H.col(0).norm(), H.col(1).norm());
    return !(H.determinant() / longest > least_height(radius_max));
}

}  // namespace sandgraph::dem
