// Pair loop of the fast kernel; included once per instruction set (no include guard by design). Equations:
// docs/how_it_works.md.
#if defined(SANDGRAPH_FAST_FORCES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_FAST_FORCES_INL
#undef SANDGRAPH_FAST_FORCES_INL
#else
#define SANDGRAPH_FAST_FORCES_INL
#endif

#include <algorithm>

#include "dem/fast/pairs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Constants of the law in every lane.
struct LawLanes {
    V young, ratio_dt, rolling, friction, rolling_limit;
    hn::Mask<D> total_rolling;
    LawLanes(const KernelConstants& k, double dt)
        : young(hn::Set(D(), 0.5 * k.young)),
          ratio_dt(hn::Set(D(), k.stiffness_ratio * dt)),
          rolling(hn::Set(D(), 0.25 * k.rolling_stiffness)),
          friction(hn::Set(D(), k.friction)),
          rolling_limit(hn::Set(D(), 0.5 * k.rolling_limit)),
          total_rolling(hn::Gt(hn::Set(D(), k.total_rolling ? 1.0 : 0.0), hn::Zero(D()))) {}
};

#if HWY_MAX_BYTES == 64
// One third-order Newton step takes the 14 bits of the machine's estimate to double precision; the square
// root and the division after it would be a longer chain to wait for.
HWY_INLINE void Distance(V square, V& dist, V& inv_dist) {
    const D d;
    const V guess = V{_mm512_rsqrt14_pd(square.raw)};
    const V e = hn::NegMulAdd(hn::Mul(square, guess), guess, hn::Set(d, 1.0));
    const V series = hn::MulAdd(hn::MulAdd(hn::Set(d, 0.3125), e, hn::Set(d, 0.375)), e, hn::Set(d, 0.5));
    inv_dist = hn::MulAdd(hn::Mul(guess, e), series, guess);
    dist = hn::Mul(square, inv_dist);
}
#else
HWY_INLINE void Distance(V square, V& dist, V& inv_dist) {
    dist = hn::Sqrt(square);
    inv_dist = hn::Div(hn::Set(D(), 1.0), dist);
}
#endif

// (eq. 17): normal, overlap and f_n = k_n max(overlap, 0); k_n = E 2 r_i r_j / (r_i + r_j) with
// 4 r_i r_j = (sum - diff)(sum + diff).
struct Normal {
    V dist, inv_dist, nx, ny, overlap, four_rr, kt_dt, fn;
    Normal(const Lanes& p, const LawLanes& k) {
        const D d;
        Distance(hn::MulAdd(p.dx, p.dx, hn::Mul(p.dy, p.dy)), dist, inv_dist);
        nx = hn::Mul(p.dx, inv_dist), ny = hn::Mul(p.dy, inv_dist);
        overlap = hn::Sub(p.r_sum, dist);
        four_rr = hn::Mul(hn::Sub(p.r_sum, p.r_diff), hn::Add(p.r_sum, p.r_diff));
        const V kn = hn::Div(hn::Mul(k.young, four_rr), p.r_sum);
        fn = hn::Mul(kn, hn::Max(overlap, hn::Zero(d)));
        kt_dt = hn::Mul(kn, k.ratio_dt);
    }
};

HWY_INLINE V Limited(V value, V limit) { return hn::Max(hn::Min(value, limit), hn::Neg(limit)); }

// (eq. 18): tangential force along e = (n_y, -n_x) with alpha_g = (r_i + r_j)/|d|, at most tan(phi) f_n.
HWY_INLINE V Tangential(const Lanes& p, const Normal& n, const LawLanes& k, double* history) {
    const D d;
    const V slip = hn::NegMulAdd(p.dvy, n.nx, hn::Mul(p.dvx, n.ny));
    const V vt = hn::MulAdd(hn::Mul(p.r_sum, n.inv_dist), slip, p.rw_sum);
    const V ft = Limited(hn::NegMulAdd(n.kt_dt, vt, hn::Load(d, history)), hn::Mul(n.fn, k.friction));
    hn::Store(ft, d, history);
    return ft;
}

// (eq. 19): rolling moment, at most eta min(r) f_n. Elastic-plastic increments remember the limited moment,
// the total form the whole -k_r theta.
HWY_INLINE V Rolling(const Lanes& p, const Normal& n, const LawLanes& k, double* history) {
    const D d;
    const V limit = hn::Mul(hn::Mul(k.rolling_limit, hn::Sub(p.r_sum, hn::Abs(p.r_diff))), n.fn);
    const V kr_dt = hn::Mul(hn::Mul(k.rolling, n.four_rr), n.kt_dt);
    const V rolled = hn::NegMulAdd(kr_dt, p.dw, hn::Load(d, history));
    const V m = Limited(rolled, limit);
    const V kept = hn::IfThenElseZero(hn::Gt(n.overlap, hn::Zero(d)), rolled);
    hn::Store(hn::IfThenElse(k.total_rolling, kept, m), d, history);
    return m;
}

// Forces of a block: (fx, fy, even, odd) of each pair on a wide machine as two halves, each in the order of
// its interleaved vectors, which the scatter joins on the way.
#if HWY_MAX_BYTES == 64
HWY_INLINE void StoreForces(V fx, V fy, V even, V odd, double* group) {
    const D d;
    hn::Store(hn::InterleaveLower(d, fx, fy), d, group);
    hn::Store(hn::InterleaveUpper(d, fx, fy), d, group + 8);
    hn::Store(hn::InterleaveLower(d, even, odd), d, group + 16);
    hn::Store(hn::InterleaveUpper(d, even, odd), d, group + 24);
}
HWY_INLINE hn::Vec<D4> ForceOf(const double* group, int pair, std::size_t) {
    const double* f = group + 8 * (pair % 2) + pair / 2 * 2;
    return hn::Vec<D4>{_mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(f)), _mm_load_pd(f + 16), 1)};
}
#else
HWY_INLINE void StoreForces(V fx, V fy, V even, V odd, double* group) {
    hn::StoreInterleaved4(fx, fy, even, odd, D(), group);
}
HWY_INLINE auto ForceOf(const double* group, int pair, std::size_t k) {
    return hn::Load(D4(), group + 4 * pair + k);
}
#endif

// The contact law on N lanes at once. Pairs without contact get f_n = 0, which also clears their history.
template <bool kStress, class PairSource>
HWY_INLINE void ContactLaw(const PairSource& source, const Arrays& s, const LawLanes& k, int first, int count,
                           double* HWY_RESTRICT force, V* sum) {
    const D d;
    const V half = hn::Set(d, 0.5);
    for (int c = 0; c < count; c += static_cast<int>(hn::Lanes(d))) {
        const Lanes p = source.Load(c);
        const Normal n(p, k);
        const V ft = Tangential(p, n, k, s.tangential + first + c),
                m = Rolling(p, n, k, s.moment + first + c);
        const V fx = hn::MulAdd(n.fn, n.nx, hn::Mul(ft, n.ny)),
                fy = hn::NegMulAdd(ft, n.nx, hn::Mul(n.fn, n.ny));
        // (eq. 20): n x f = -f_t, so the torques are +(r - overlap/2) f_t on both, -M on i and +M on j: in
        // two parts, |d|/2 f_t on both and (r_j - r_i)/2 f_t + M with the sign of the grain.
        const V half_ft = hn::Mul(half, ft);
        const V even = hn::Mul(half_ft, n.dist), odd = hn::MulAdd(half_ft, p.r_diff, m);
        StoreForces(fx, fy, even, odd, force + 4 * c);
        if constexpr (kStress) {  // (eq. 23)
            sum[0] = hn::MulAdd(p.dx, fx, sum[0]), sum[1] = hn::MulAdd(p.dx, fy, sum[1]);
            sum[2] = hn::MulAdd(p.dy, fx, sum[2]), sum[3] = hn::MulAdd(p.dy, fy, sum[3]);
        }
    }
}

// Pair by pair, so two pairs of one grain never conflict; the pair order keeps neighbours in time apart.
HWY_INLINE void Scatter(const Arrays& s, int first, int count, const double* HWY_RESTRICT pair_force) {
    const D4 d;
    alignas(32) static constexpr double kOnI[4] = {-1, -1, 1, -1};
    const std::uint16_t *HWY_RESTRICT pi = s.i + first, *HWY_RESTRICT pj = s.j + first;
    double* force = s.force;
    for (int group = 0; group < count; group += FastState::kLanes) HWY_UNROLL(8)
    for (int c = group; c < group + FastState::kLanes; ++c) {
        double *on_i = force + std::size_t{4} * pi[c], *on_j = force + std::size_t{4} * pj[c];
        for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
            const auto f = ForceOf(pair_force + 4 * group, c - group, k);
            hn::Store(hn::MulAdd(f, hn::Load(d, kOnI + k), hn::Load(d, on_i + k)), d, on_i + k);
            hn::Store(hn::Add(f, hn::Load(d, on_j + k)), d, on_j + k);
        }
    }
}

// Pairs [begin, end), block by block. `kWrapped`: some are with an image of j.
template <bool kStress, bool kWrapped>
HWY_INLINE void ForcesOf(const Arrays& s, const ImageTable& images, const LawLanes& law, int begin, int end,
                         V* sum) {
    PairBuffers buffers;
    for (int first = begin; first < end; first += kBlock) {
        const int count = std::min(kBlock, end - first);
        const PairSource<kWrapped> source(s, images, first, count, buffers);
        ContactLaw<kStress>(source, s, law, first, count, buffers.force, sum);
        Scatter(s, first, count, buffers.force);
    }
}

template <bool kStress>
HWY_INLINE void ForceLoop(FastState& s, const KernelConstants& k, double dt, V* sum) {
    std::fill(s.force.begin(), s.force.end(), 0.0);
    const ImageTable images(s);
    const Arrays arrays(s);
    const LawLanes law(k, dt);
    ForcesOf<kStress, false>(arrays, images, law, 0, s.inner, sum);
    ForcesOf<kStress, true>(arrays, images, law, s.inner, s.slots, sum);
}

inline void ContactForces(FastState& s, const KernelConstants& k, double dt) {
    ForceLoop<false>(s, k, dt, nullptr);
}

inline void ContactForcesAndStress(FastState& s, const KernelConstants& k, double dt, double* moment_sum) {
    const D d;
    V sum[4] = {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    ForceLoop<true>(s, k, dt, sum);
    for (int c = 0; c < 4; ++c) moment_sum[c] = hn::GetLane(hn::SumOfLanes(d, sum[c]));
}

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
