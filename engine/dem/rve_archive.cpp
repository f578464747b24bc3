#include <algorithm>

#include "dem/rve.hpp"

namespace sandgraph::dem {
namespace {

void put(std::vector<double>& out, const Mat2& m) {
    out.insert(out.end(), {m(0, 0), m(0, 1), m(1, 0), m(1, 1)});
}

Mat2 take(const double*& in) {
    const Mat2 m = (Mat2() << in[0], in[1], in[2], in[3]).finished();
    in += 4;
    return m;
}

template <class Real>
void take(const double*& in, std::vector<Real>& out, std::size_t n) {
    out.resize(n);
    std::transform(in, in + n, out.begin(), [](double value) { return static_cast<Real>(value); });
    in += n;
}

// A pair in one integer: i, j and image side by side.
std::int64_t pair_code(const CompactPacking& p, std::size_t c) {
    return std::int64_t(p.i[c]) << 32 | std::int64_t(p.j[c]) << 8 | p.image[c];
}

void save_packing(const CompactPacking& p, std::vector<double>& reals, std::vector<std::int64_t>& integers) {
    for (const Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) put(reals, *m);
    reals.push_back(p.approach);
    reals.insert(reals.end(), p.position.begin(), p.position.end());
    for (const auto* v : {&p.velocity, &p.tangential, &p.moment})
        reals.insert(reals.end(), v->begin(), v->end());
    integers.insert(integers.end(), {p.pairs, std::int64_t(p.i.size())});
    for (std::size_t c = 0; c < p.i.size(); ++c) integers.push_back(pair_code(p, c));
}

void load_packing(CompactPacking& p, const double*& reals, const std::int64_t*& integers) {
    for (Mat2* m : {&p.H, &p.L, &p.H_force, &p.LH, &p.stress}) *m = take(reals);
    p.approach = *reals++;
    p.pairs = static_cast<int>(*integers++);
    const std::size_t slots = *integers++;
    take(reals, p.position, 2 * p.grains->radius.size());
    take(reals, p.velocity, 3 * p.grains->radius.size());
    take(reals, p.tangential, slots);
    take(reals, p.moment, slots);
    p.i.resize(slots), p.j.resize(slots), p.image.resize(slots);
    for (std::size_t c = 0; c < slots; ++c) {
        const std::int64_t code = *integers++;
        p.i[c] = std::uint16_t(code >> 32), p.j[c] = std::uint16_t(code >> 8),
        p.image[c] = std::uint8_t(code);
    }
}

}  // namespace

void Rve::save(std::vector<double>& reals, std::vector<std::int64_t>& integers) const {
    integers.insert(integers.end(), {own_ != nullptr, floating_});
    reals.insert(reals.end(), {angle_, volume_, contact_volume_});
    put(reals, pending_);
    if (own_) save_packing(*own_, reals, integers);
}

void Rve::load(const double*& reals, const std::int64_t*& integers) {
    const bool own = *integers++;
    floating_ = *integers++;
    angle_ = *reals++, volume_ = *reals++, contact_volume_ = *reals++;
    pending_ = take(reals);
    own_.reset();
    if (!own) return;
    own_ = std::make_unique<CompactPacking>();
    own_->grains = initial_->grains;
    load_packing(*own_, reals, integers);
}

}  // namespace sandgraph::dem
