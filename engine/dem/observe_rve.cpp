#include "dem/packing/observe.hpp"
#include "dem/reference/contact.hpp"
#include "dem/stretch.hpp"

namespace sandgraph::dem {
namespace {

// As contact_forces of a Packing, but the pairs are known: a list that the kernel just used holds every
// contact. In the order of the pair loop.
std::vector<ContactForce> listed_contacts(const CompactPacking& p, const Material& m) {
    const std::vector<double>& r = p.grains->radius;
    std::vector<ContactForce> out;
    out.reserve(p.i.size());
    for (std::size_t k = 0; k < p.i.size(); ++k) {
        const std::size_t i = p.i[k], j = p.j[k];
        if (i >= r.size() || j >= r.size()) continue;  // a lane that only pads
        const Vec2 cell(p.image[k] / 3 - 1, p.image[k] % 3 - 1);
        const Vec2 d = Vec2(p.position[2 * j], p.position[2 * j + 1]) + p.H * cell -
                       Vec2(p.position[2 * i], p.position[2 * i + 1]);
        const double reach = r[i] + r[j];
        if (d.squaredNorm() >= reach * reach) continue;
        ContactForce c{p.i[k], p.j[k], std::int16_t(cell.x()), std::int16_t(cell.y())};
        c.n = d.normalized();
        c.overlap = reach - d.norm();
        c.f_n = PairConstants(r[i], r[j], m).k_n * c.overlap;
        c.f_t = double(p.tangential[k]) * Vec2(c.n.y(), -c.n.x());
        const double limit = m.rolling_limit * std::min(r[i], r[j]) * c.f_n;
        c.moment = std::clamp(double(p.moment[k]), -limit, limit);
        out.push_back(c);
    }
    return out;
}

// Grains and cell; contact history stays with the pairs.
Packing grains_of(const CompactPacking& p) {
    const std::size_t n = p.grains->radius.size();
    Packing out;
    out.H = p.H, out.L = p.L, out.r = p.grains->radius;
    for (std::vector<double>* v : {&out.x, &out.y, &out.vx, &out.vy, &out.spin}) v->resize(n);
    for (std::size_t g = 0; g < n; ++g) {
        out.x[g] = p.position[2 * g], out.y[g] = p.position[2 * g + 1];
        out.vx[g] = p.velocity[3 * g], out.vy[g] = p.velocity[3 * g + 1], out.spin[g] = p.velocity[3 * g + 2];
    }
    return out;
}

}  // namespace

// The packing lies in its own frame, which turned with the point.
Observables observe(const Rve& rve, const Material& material) {
    const CompactPacking& packing = rve.packing();
    Observables seen = observe(grains_of(packing), listed_contacts(packing, material), material);
    seen.stress = rve.stress();
    seen.fabric = turned(seen.fabric, rve.angle());
    seen.porosity = rve.porosity();
    return seen;
}

}  // namespace sandgraph::dem
