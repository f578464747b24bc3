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
    own_.reset();
    if (!own) return;
    own_ = std::make_unique<CompactPacking>();
    own_->grains = initial_->grains;
    load_packing(*own_, in);
}

}  // namespace sandgraph::dem
