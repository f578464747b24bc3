#include "dem/packing/observe.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "dem/reference/contact.hpp"
#include "dem/reference/pairs.hpp"

namespace sandgraph::dem {
namespace {

// A contact counts as sliding when the Coulomb limit is reached up to the round-off of a CompactPacking: in the
// mixed kernel's form that of a float's overlap.
constexpr double at_limit = 1 - 1e-4;

void observe_fabric(Observables& out, std::span<const ContactForce> contacts) {
    if (contacts.empty()) return;
    for (const ContactForce& c : contacts) out.fabric += c.n * c.n.transpose();
    out.fabric /= static_cast<double>(contacts.size());
    const Mat2 F = 4 * (out.fabric - 0.5 * Mat2::Identity());
    out.anisotropy = std::sqrt(0.5 * F.squaredNorm());
}

void observe_coordination(Observables& out, std::span<const ContactForce> contacts, std::size_t grains) {
    std::vector<int> of(grains, 0);
    for (const ContactForce& c : contacts) ++of[c.i], ++of[c.j];
    int held = 0, sum = 0;
    for (int k : of)
        if (k >= 2) ++held, sum += k;
    out.contacts = static_cast<int>(contacts.size());
    out.coordination = grains ? 2.0 * out.contacts / static_cast<double>(grains) : 0;
    out.mechanical_coordination = held ? static_cast<double>(sum) / held : 0;
}

void observe_contacts(Observables& out, const Packing& p, std::span<const ContactForce> contacts,
                      const Material& material) {
    const double tan_phi = std::tan(material.friction_angle);
    int sliding = 0;
    for (const ContactForce& c : contacts) {
        const PairConstants k(p.r[c.i], p.r[c.j], material);
        out.elastic_normal += c.f_n * c.f_n / (2 * k.k_n);
        out.elastic_tangential += k.k_t > 0 ? c.f_t.squaredNorm() / (2 * k.k_t) : 0;
        out.elastic_rolling += k.k_r > 0 ? c.moment * c.moment / (2 * k.k_r) : 0;
        out.overlap_max = std::max(out.overlap_max, c.overlap);
        sliding += c.f_t.norm() >= at_limit * tan_phi * c.f_n;
    }
    out.sliding_fraction =
        contacts.empty() ? 0 : static_cast<double>(sliding) / static_cast<double>(contacts.size());
}

// Fluctuation velocity v - L x; the spin is taken as it is.
void observe_kinetic(Observables& out, const Packing& p, const Material& material) {
    for (std::size_t g = 0; g < p.vx.size(); ++g) {
        const double m = material.density * material.depth * std::numbers::pi * p.r[g] * p.r[g];
        const Vec2 w = Vec2(p.vx[g], p.vy[g]) - p.L * Vec2(p.x[g], p.y[g]);
        out.kinetic_translation += 0.5 * m * w.squaredNorm();
        out.kinetic_rotation += 0.25 * m * p.r[g] * p.r[g] * p.spin[g] * p.spin[g];
    }
}

double unbalanced(std::size_t grains, std::span<const ContactForce> contacts) {
    std::vector<Vec2> net(grains, Vec2::Zero());
    double contact_sum = 0, net_sum = 0;
    for (const ContactForce& c : contacts) {
        const Vec2 f = c.f_n * c.n + c.f_t;
        net[c.j] += f;
        net[c.i] -= f;
        contact_sum += f.norm();
    }
    for (const Vec2& f : net) net_sum += f.norm();
    if (contact_sum == 0) return 0;
    return (net_sum / static_cast<double>(grains)) / (contact_sum / static_cast<double>(contacts.size()));
}

[[maybe_unused]] bool all_between(std::span<const ContactForce> contacts, std::size_t grains) {
    return std::ranges::all_of(contacts, [&](const ContactForce& c) {
        return c.i >= 0 && c.j >= 0 && std::size_t(c.i) < grains && std::size_t(c.j) < grains;
    });
}

std::vector<Vec2> centres(const Packing& p) {
    std::vector<Vec2> x(p.size());
    for (std::size_t g = 0; g < p.size(); ++g) x[g] = {p.x[g], p.y[g]};
    return x;
}

ContactForce as_it_lies(const Packing& p, const PairKey& key, const Vec2& d, const Material& material) {
    ContactForce c{key.i, key.j, key.cell_x, key.cell_y};
    c.n = d.normalized();
    c.overlap = p.r[key.i] + p.r[key.j] - d.norm();
    c.f_n = PairConstants(p.r[key.i], p.r[key.j], material).k_n * c.overlap;
    return c;
}

}  // namespace

std::vector<ContactForce> contact_forces(const Packing& p, const Material& material) {
    SG_EXPECT(p.y.size() == p.size() && p.r.size() == p.size());
    const std::vector<Vec2> x = centres(p);
    std::vector<ContactForce> out;
    for (const PairKey& key : near_pairs(x, p.r, p.H, 0)) {
        const Vec2 d = x[key.j] + p.H * Vec2(key.cell_x, key.cell_y) - x[key.i];
        out.push_back(as_it_lies(p, key, d, material));
    }
    const auto key_of = [](const auto& c) { return PairKey{c.i, c.j, c.cell_x, c.cell_y}; };
    for (const Contact& old : p.contacts) {
        const auto it = std::ranges::lower_bound(out, key_of(old), {}, key_of);
        if (it == out.end() || key_of(*it) != key_of(old)) continue;
        it->f_t = old.tangential * Vec2(it->n.y(), -it->n.x());
        const double limit = material.rolling_limit * std::min(p.r[it->i], p.r[it->j]) * it->f_n;
        it->moment = std::clamp(old.moment, -limit, limit);
    }
    return out;
}

// docs/how_it_works.md (eq. 23).
Mat2 love_weber_stress(const Packing& p, std::span<const ContactForce> contacts, const Material& material) {
    SG_EXPECT(p.area() != 0 && material.depth > 0);
    Mat2 sum = Mat2::Zero();
    for (const ContactForce& c : contacts)
        sum += (p.r[c.i] + p.r[c.j] - c.overlap) * c.n * (c.f_n * c.n + c.f_t).transpose();
    return sum / (p.area() * material.depth);
}

Observables observe(const Packing& p, std::span<const ContactForce> contacts, const Material& material) {
    SG_EXPECT(all_between(contacts, p.size()));
    SG_EXPECT(p.vx.empty() || (p.vx.size() == p.size() && p.spin.size() == p.size()));
    Observables out;
    out.stress = love_weber_stress(p, contacts, material);
    out.porosity = porosity(p);
    observe_fabric(out, contacts);
    observe_coordination(out, contacts, p.size());
    observe_contacts(out, p, contacts, material);
    observe_kinetic(out, p, material);
    out.unbalanced = unbalanced(p.size(), contacts);
    return out;
}

}  // namespace sandgraph::dem
