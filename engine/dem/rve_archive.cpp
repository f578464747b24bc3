#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dem/rve.hpp"

namespace sandgraph::dem {
namespace {

void put(ByteWriter& out, const Mat2& m) { out.put(std::span<const double>(m.data(), 4)); }
void take(ByteReader& in, Mat2& m) { in.take(std::span<double>(m.data(), 4)); }

void save_packing(const CompactPacking& p, ByteWriter& out) {
    for (const Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) put(out, *m);
    out.put(p.approach), out.put(p.pairs), out.put(p.inner);
    out.put(p.position), out.put(p.velocity);
    out.put(p.i), out.put(p.j), out.put(p.image);
    out.put(p.tangential), out.put(p.moment);
}

void load_packing(CompactPacking& p, ByteReader& in) {
    for (Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) take(in, *m);
    in.take(p.approach), in.take(p.pairs), in.take(p.inner);
    in.take(p.position), in.take(p.velocity);
    in.take(p.i), in.take(p.j), in.take(p.image);
    in.take(p.tangential), in.take(p.moment);
}

// The pair loop indexes by these without a look; the padding grain N is one of its partners.
void require_sound(const CompactPacking& p) {
    const std::size_t grains = p.grains->radius.size(), slots = p.i.size();
    require_state(p.position.size() == 2 * grains && p.velocity.size() == 3 * grains, "grains");
    require_state(slots % FastState::kLanes == 0 && p.j.size() == slots && p.image.size() == slots &&
                      p.tangential.size() == slots && p.moment.size() == slots,
                  "pairs");
    const auto most = static_cast<int>(slots);
    require_state(p.pairs >= 0 && p.pairs <= most && p.inner >= 0 && p.inner <= most &&
                      p.inner % FastState::kLanes == 0,
                  "pairs");
    require_indices(p.i, grains + 1, "pairs"), require_indices(p.j, grains + 1, "pairs");
    require_indices(p.image, 9, "pairs");
    for (const Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) require_state(m->allFinite(), "numbers");
    require_state(p.H.determinant() > 0, "cells");
    require_state(std::isfinite(p.approach), "numbers");
    const auto finite = [](double value) { return std::isfinite(value); };
    require_state(std::ranges::all_of(p.position, finite) && std::ranges::all_of(p.velocity, finite) &&
                      std::ranges::all_of(p.tangential, finite) && std::ranges::all_of(p.moment, finite),
                  "numbers");
}

}  // namespace

void Rve::save(ByteWriter& out) const {
    out.put(own_ != nullptr), out.put(floating_);
    out.put(angle_), out.put(volume_), out.put(contact_volume_);
    put(out, pending_);
    if (own_) save_packing(*own_, out);
}

void Rve::load(ByteReader& in) {
    bool own = false;
    in.take(own), in.take(floating_);
    in.take(angle_), in.take(volume_), in.take(contact_volume_);
    take(in, pending_);
    require_state(std::isfinite(angle_) && volume_ > 0 && contact_volume_ > 0 && pending_.allFinite(),
                  "numbers");
    require_state(own || !floating_, "flags");  // only a packing of its own opens up
    own_.reset();
    if (!own) return;
    auto packing = std::make_unique<CompactPacking>();
    packing->grains = initial_->grains;
    load_packing(*packing, in);
    require_sound(*packing);
    own_ = std::move(packing);
}

}  // namespace sandgraph::dem
