#include "dem/fast/packing.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/contracts.hpp"

namespace sandgraph::dem {
namespace {

constexpr int kLargest = 65000;  // pairs address grains with 16 bits

void load_grain(const Packing& p, const Material& m, int g, FastState& s) {
    const double mass = m.density * m.depth * std::numbers::pi * p.r[g] * p.r[g];
    const double spin = p.spin.empty() ? 0 : p.spin[g];
    const double vx = p.vx.empty() ? 0 : p.vx[g], vy = p.vy.empty() ? 0 : p.vy[g];
    set_grain(s.grain(g), p.x[g], p.y[g], vx, vy, p.r[g], spin);
    s.inverse_mass[g] = 1 / mass;
    s.inverse_inertia[g] = 2 / (mass * p.r[g] * p.r[g]);
}

std::vector<double> picked(const std::vector<double>& values, const std::vector<int>& order) {
    std::vector<double> out;
    if (values.empty()) return out;
    out.reserve(order.size());
    for (const int g : order) out.push_back(values[g]);
    return out;
}

double fraction(double s) { return s - std::floor(s); }

}  // namespace

void resize_grains(FastState& s, int n) {
    SG_EXPECT(n >= 0 && n <= kLargest);
    const int room = padded(n + 1);
    s.grains = n, s.masses_of.reset();
    s.record.assign(FastState::kRecord * room, 0), s.force.assign(4 * room, 0);
    s.inverse_mass.assign(room, 0), s.inverse_inertia.assign(room, 0);
    set_grain(s.grain(n), 0, 0, 0, 0, 1e-6, 0);
}

void load(const Packing& p, const Material& material, FastState& s) {
    SG_EXPECT(p.y.size() == p.size() && p.r.size() == p.size());
    SG_EXPECT(p.vx.empty() || (p.vx.size() == p.size() && p.vy.size() == p.size()));
    SG_EXPECT(p.spin.empty() || p.spin.size() == p.size());
    const int n = static_cast<int>(p.size());
    if (n > kLargest) throw std::invalid_argument("the fast kernel takes at most 65,000 grains a packing");
    resize_grains(s, n);
    for (int g = 0; g < n; ++g) load_grain(p, material, g, s);
    s.radius_max = n > 0 ? *std::max_element(p.r.begin(), p.r.end()) : 0;
    s.H = s.H_force = p.H, s.L = p.L, s.LH = p.L * p.H;
    s.pairs = s.slots = s.inner = 0;
}

void contact_history(const FastState& s, std::vector<Contact>& out) {
    SG_EXPECT(static_cast<std::size_t>(s.slots) == s.tangential.size() &&
              s.moment.size() == s.tangential.size());
    out.clear();
    for (int c = 0; c < s.slots; ++c) {
        if (s.tangential[c] == 0 && s.moment[c] == 0) continue;
        out.push_back({s.i[c], s.j[c], std::int16_t(s.image[c] / 3 - 1), std::int16_t(s.image[c] % 3 - 1),
                       s.tangential[c], s.moment[c]});
    }
}

Packing unload(const FastState& s) {
    Packing p;
    p.H = s.H, p.L = s.L;
    for (int g = 0; g < s.grains; ++g) {
        const double* a = s.grain(g);
        p.x.push_back(a[0]), p.y.push_back(a[1]);
        p.vx.push_back(a[2]), p.vy.push_back(a[3]);
        p.r.push_back(a[4]), p.spin.push_back(a[6]);
    }
    contact_history(s, p.contacts);
    SG_ENSURE(p.size() == static_cast<std::size_t>(s.grains));
    return p;
}

std::vector<int> strip_order(const Packing& p) {
    const Mat2 inverse = p.H.inverse();
    const double strips = std::max(1.0, std::floor(std::sqrt(static_cast<double>(p.size()))));
    std::vector<std::pair<double, double>> place(p.size());
    for (std::size_t g = 0; g < p.size(); ++g) {
        const Vec2 s = inverse * Vec2(p.x[g], p.y[g]);
        place[g] = {std::floor(fraction(s.x()) * strips), fraction(s.y())};
    }
    std::vector<int> order(p.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place[a] < place[b]; });
    SG_ENSURE(distinct_below(order, p.size()));
    return order;
}

std::vector<int> memory_order(const Packing& packing) {
    constexpr std::size_t kSmall = 1000;
    if (packing.size() > kSmall) return strip_order(packing);
    std::vector<int> as_given(packing.size());
    std::iota(as_given.begin(), as_given.end(), 0);
    return as_given;
}

std::vector<int> inverse_order(const std::vector<int>& order) {
    SG_EXPECT(distinct_below(order, order.size()));
    std::vector<int> out(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) out[order[k]] = static_cast<int>(k);
    return out;
}

Packing reordered(const Packing& p, const std::vector<int>& order) {
    SG_EXPECT(order.size() == p.size());
    const std::vector<int> place = inverse_order(order);
    Packing out = p;
    out.x = picked(p.x, order), out.y = picked(p.y, order), out.r = picked(p.r, order);
    out.vx = picked(p.vx, order), out.vy = picked(p.vy, order), out.spin = picked(p.spin, order);
    for (Contact& c : out.contacts) c.i = place[c.i], c.j = place[c.j];
    return out;
}

}  // namespace sandgraph::dem
