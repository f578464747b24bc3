#include "dem/packing/compact_packing.hpp"

#include <algorithm>
#include <numbers>
#include <span>

#include "base/contracts.hpp"
#include "base/hash.hpp"
#include "dem/fast/kernel.hpp"
#include "dem/fast/neighbour_list.hpp"
#include "dem/fast/packing.hpp"
#include "dem/mixed/packing.hpp"

namespace sandgraph::dem {
namespace {

std::shared_ptr<const GrainSet> grain_set(const FastState& s) {
    auto set = std::make_shared<GrainSet>();
    for (int g = 0; g < s.grains; ++g) {
        const double r = s.grain(g)[4];
        set->radius.push_back(r);
        set->inverse_mass.push_back(s.inverse_mass[g]);
        set->inverse_inertia.push_back(s.inverse_inertia[g]);
        set->solid_area += std::numbers::pi * r * r;
        set->radius_max = std::max(set->radius_max, r);
        set->mean_diameter += 2 * r / s.grains;
    }
    return set;
}

// Masses are the same from visit to visit as long as the packings share their grains.
void take_masses(const std::shared_ptr<const GrainSet>& set, FastState& s) {
    if (s.masses_of == set) return;
    const int n = static_cast<int>(set->radius.size());
    if (s.grains != n) resize_grains(s, n);
    std::copy(set->inverse_mass.begin(), set->inverse_mass.end(), s.inverse_mass.begin());
    std::copy(set->inverse_inertia.begin(), set->inverse_inertia.end(), s.inverse_inertia.begin());
    s.radius_max = set->radius_max;
    s.masses_of = set;
}

void take_masses(const std::shared_ptr<const GrainSet>& set, MixedState& s) {
    if (s.grains_of == set) return;
    const int n = static_cast<int>(set->radius.size());
    resize_grains(s, n);
    const auto narrow = [](const std::vector<double>& from, Aligned<float>& to) {
        std::transform(from.begin(), from.end(), to.begin(), [](double x) { return static_cast<float>(x); });
    };
    narrow(set->radius, s.radius);
    narrow(set->inverse_mass, s.inverse_mass), narrow(set->inverse_inertia, s.inverse_inertia);
    s.radius_max = set->radius_max;
    s.grains_of = set;
}

// Of the other kernel's form: a list of its own.
void convert(const CompactPacking& p, FastState& s) {
    const Packing packing = to_packing(p);
    load(packing, Material{}, s);
    take_masses(p.grains, s);
    NeighbourList().relist(s, packing.contacts);
}

}  // namespace

std::size_t CompactPacking::bytes() const {
    return sizeof *this + (mixed ? mixed->bytes() : 0) + 8 * position.capacity() +
           4 * (velocity.capacity() + tangential.capacity() + moment.capacity()) +
           2 * (i.capacity() + j.capacity()) + image.capacity();
}

std::shared_ptr<const CompactPacking> compact(const Packing& packing, const Material& material,
                                              const Mat2& stress) {
    SG_EXPECT(packing.size() > 0 && stress.allFinite());
    FastState state;
    load(packing, material, state);
    NeighbourList neighbours;
    neighbours.relist(state, packing.contacts);
    auto out = std::make_shared<CompactPacking>();
    out->grains = grain_set(state);
    pack(state, *out);
    out->stress = stress;
    SG_ENSURE(out->grains->radius.size() == packing.size());
    return out;
}

void unpack(const CompactPacking& p, FastState& s) {
    if (p.mixed) return convert(p, s);
    SG_EXPECT(p.grains != nullptr && p.position.size() == 2 * p.grains->radius.size());
    SG_EXPECT(p.velocity.size() == 3 * p.grains->radius.size());
    SG_EXPECT(p.j.size() == p.i.size() && p.image.size() == p.i.size());
    SG_EXPECT(p.tangential.size() == p.i.size() && p.moment.size() == p.i.size());
    take_masses(p.grains, s);
    unpack_grains(p.position.data(), p.velocity.data(), p.grains->radius.data(), s.grains, s.record.data());
    s.pairs = p.pairs, s.slots = static_cast<int>(p.i.size()), s.inner = p.inner;
    s.i.assign(p.i.begin(), p.i.end()), s.j.assign(p.j.begin(), p.j.end());
    s.image.assign(p.image.begin(), p.image.end());
    s.tangential.resize(s.slots), s.moment.resize(s.slots);
    widen(p.tangential.data(), s.slots, s.tangential.data());
    widen(p.moment.data(), s.slots, s.moment.data());
    s.H = p.H, s.L = p.L, s.H_force = p.H_force, s.LH = p.LH, s.approach = p.approach;
}

void pack(const FastState& s, CompactPacking& p) {
    p.mixed.reset();
    SG_EXPECT(s.i.size() == static_cast<std::size_t>(s.slots) && s.j.size() == s.i.size());
    p.position.resize(2 * s.grains);
    p.velocity.resize(3 * s.grains);
    pack_grains(s.record.data(), s.grains, p.position.data(), p.velocity.data());
    p.i.assign(s.i.begin(), s.i.end()), p.j.assign(s.j.begin(), s.j.end());
    p.image.assign(s.image.begin(), s.image.end());
    p.tangential.resize(s.slots), p.moment.resize(s.slots);
    narrow(s.tangential.data(), s.slots, p.tangential.data());
    narrow(s.moment.data(), s.slots, p.moment.data());
    p.pairs = s.pairs, p.inner = s.inner;
    p.H = s.H, p.L = s.L, p.H_force = s.H_force, p.LH = s.LH, p.approach = s.approach;
}

void unpack(const CompactPacking& p, MixedState& s, MixedList& list) {
    SG_EXPECT(p.grains != nullptr);
    take_masses(p.grains, s);
    if (!p.mixed) return place(to_packing(p), s, list);
    s.packing = *p.mixed;
    s.stiffness.resize(s.packing.partner.size()), s.stiffness_known = false;
}

void pack(const MixedState& s, CompactPacking& p) {
    p.mixed = s.packing;  // array by array: memory is kept
    p.H = p.H_force = s.packing.H, p.L = s.packing.L, p.LH = p.L * p.H;
}

bool fits_mixed(const CompactPacking& p) {
    return p.mixed || !too_thin(p.H * reduce_cell(p.H).U.cast<double>(), p.grains->radius_max);
}

std::shared_ptr<const CompactPacking> in_mixed_form(std::shared_ptr<const CompactPacking> packing) {
    SG_EXPECT(packing != nullptr);
    if (packing->mixed || !fits_mixed(*packing)) return packing;
    MixedState state;
    MixedList list;
    unpack(*packing, state, list);
    auto out = std::make_shared<CompactPacking>();
    pack(state, *out);
    out->grains = packing->grains, out->stress = packing->stress;
    return out;
}

Packing to_packing(const CompactPacking& p) {
    if (p.mixed) return to_packing(*p.mixed, p.grains->radius);
    FastState state;
    unpack(p, state);
    return unload(state);
}

std::int64_t content_hash(const CompactPacking& p) {
    Hasher hasher;
    const auto add = [&](const auto& values) { hasher.add(std::as_bytes(std::span(values))); };
    add(p.grains->radius), add(p.position);
    if (p.mixed) {
        add(p.mixed->x), add(p.mixed->y), add(p.mixed->rows), add(p.mixed->partner);
        add(p.mixed->loose_first), add(p.mixed->tangential), add(p.mixed->moment);
    }
    add(p.i), add(p.j), add(p.image);
    add(p.tangential), add(p.moment);
    hasher.add(std::as_bytes(std::span(p.H.data(), 4)));
    return static_cast<std::int64_t>(hasher.value());
}

}  // namespace sandgraph::dem
