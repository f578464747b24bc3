// Weights of a block of points, one SIMD lane each. Included once per target by transfer_kernel.cpp.
#if defined(SANDGRAPH_MPM_GIMP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_MPM_GIMP_INL
#undef SANDGRAPH_MPM_GIMP_INL
#else
#define SANDGRAPH_MPM_GIMP_INL
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::mpm::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr std::size_t block = 8;  // points handled together

// Along one axis: the three weights and their gradients, and the first node, point by point.
struct alignas(64) AxisWeights {
    double S[3][block], dS[3][block], base[block];
};

struct Axis {
    double origin, half, cell;
};

// mpm/shape.hpp: average(), for the domains [c - half, c + half].
template <class D>
HWY_INLINE void weigh(D d, const double* HWY_RESTRICT c, const Axis& axis, std::size_t k, AxisWeights& w) {
    const auto one = hn::Set(d, 1.0), zero = hn::Zero(d);
    const double width = 2 * axis.half / axis.cell;
    const auto per_width = hn::Set(d, 0.5 / width), per_length = hn::Set(d, 0.5 / axis.half);
    const auto a =
        hn::Mul(hn::Sub(hn::Sub(hn::Load(d, c + k), hn::Set(d, axis.half)), hn::Set(d, axis.origin)),
                hn::Set(d, 1 / axis.cell));
    const auto base = hn::Floor(a);
    const auto ta = hn::Sub(a, base), tb = hn::Add(ta, hn::Set(d, width));
    const auto na = hn::Sub(one, ta), nb = hn::Max(zero, hn::Sub(one, tb)),
               mb = hn::Max(zero, hn::Sub(tb, one));
    const auto s0 = hn::Mul(per_width, hn::NegMulAdd(nb, nb, hn::Mul(na, na)));
    const auto s2 = hn::Mul(per_width, hn::Mul(mb, mb));
    const auto d0 = hn::Mul(per_length, hn::Sub(nb, na)), d2 = hn::Mul(per_length, mb);
    hn::Store(base, d, w.base + k);
    hn::Store(s0, d, w.S[0] + k);
    hn::Store(hn::Sub(hn::Sub(one, s0), s2), d, w.S[1] + k);
    hn::Store(s2, d, w.S[2] + k);
    hn::Store(d0, d, w.dS[0] + k);
    hn::Store(hn::Neg(hn::Add(d0, d2)), d, w.dS[1] + k);
    hn::Store(d2, d, w.dS[2] + k);
}

HWY_INLINE void weigh_block(const double* HWY_RESTRICT c, const Axis& axis, AxisWeights& w) {
    const hn::CappedTag<double, block> d;
    for (std::size_t k = 0; k < block; k += hn::MaxLanes(d)) weigh(d, c, axis, k, w);
}

// N doubles of one node as one, two or four vectors of this target.
template <std::size_t N>
struct Record {
    using D = hn::CappedTag<double, N>;
    static constexpr std::size_t lanes = hn::MaxLanes(D()), parts = N / lanes;
    hn::Vec<D> part[parts];

    static HWY_INLINE Record load(const double* HWY_RESTRICT from) {
        Record r;
        for (std::size_t q = 0; q < parts; ++q) r.part[q] = hn::Load(D(), from + q * lanes);
        return r;
    }
    static HWY_INLINE Record zero() {
        Record r;
        for (auto& v : r.part) v = hn::Zero(D());
        return r;
    }
    HWY_INLINE void store(double* HWY_RESTRICT to) const {
        for (std::size_t q = 0; q < parts; ++q) hn::Store(part[q], D(), to + q * lanes);
    }
    // this + weight * r
    HWY_INLINE Record plus(double weight, const Record& r) const {
        Record sum;
        const auto w = hn::Set(D(), weight);
        for (std::size_t q = 0; q < parts; ++q) sum.part[q] = hn::MulAdd(w, r.part[q], part[q]);
        return sum;
    }
};

}  // namespace sandgraph::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
