// Pair loop of the fast kernel; included once per instruction set (no include guard by design).
#if defined(SANDGRAPH_FAST_FORCES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_FAST_FORCES_INL
#undef SANDGRAPH_FAST_FORCES_INL
#else
#define SANDGRAPH_FAST_FORCES_INL
#endif

#include <algorithm>

#include "dem/fast_state.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Lanes are capped at FastState::kLanes, the padding of every array.
using D = hn::CappedTag<double, FastState::kLanes>;
using V = hn::Vec<D>;
using D4 = hn::CappedTag<double, 4>;

inline constexpr int kBlock = 64;  // pairs staged at a time: the staging buffers stay in L1

// Differences of the two records of a pair, staged for the vector loop: (dx, dy, dvx, dvy) of the image of j
// seen from i, and (r_i + r_j, r_i w_i + r_j w_j, w_j - w_i, r_j - r_i).
struct Staging {
    alignas(64) double geometry[4 * kBlock];
    alignas(64) double rotation[4 * kBlock];
    alignas(64) double force[4 * kBlock];
};

// Image offsets: H c and L H_old c for the nine neighbouring cells, as records to add to A_j.
struct ImageTable {
    alignas(64) double shift[4 * 9];
    explicit ImageTable(const FastState& s) {
        for (int image = 0; image < 9; ++image) {
            const Vec2 c(image / 3 - 1, image % 3 - 1);
            const Vec2 position = s.H * c, velocity = s.LH * c;
            double* out = shift + 4 * image;
            out[0] = position.x(), out[1] = position.y(), out[2] = velocity.x(), out[3] = velocity.y();
        }
    }
};

// The arrays of a state as local pointers: vector stores may alias anything, members would be reloaded each
// time.
struct Arrays {
    const double *HWY_RESTRICT a, *HWY_RESTRICT b;
    double* HWY_RESTRICT force;
    const std::uint16_t *HWY_RESTRICT i, *HWY_RESTRICT j;
    const std::uint8_t* HWY_RESTRICT image;
    double *HWY_RESTRICT tangential, *HWY_RESTRICT moment;
    explicit Arrays(FastState& s)
        : a(s.a.data()),
          b(s.b.data()),
          force(s.force.data()),
          i(s.i.data()),
          j(s.j.data()),
          image(s.image.data()),
          tangential(s.tangential.data()),
          moment(s.moment.data()) {}
};

HWY_INLINE void Stage(const Arrays& s, const ImageTable& images, int first, int count, Staging& out) {
    const D4 d;
    alignas(32) static constexpr double kSign[4] = {1, 1, -1, -1};
    const double *HWY_RESTRICT a = s.a, *HWY_RESTRICT b = s.b, *HWY_RESTRICT shifts = images.shift;
    const std::uint16_t *HWY_RESTRICT pi = s.i + first, *HWY_RESTRICT pj = s.j + first;
    const std::uint8_t* HWY_RESTRICT image = s.image + first;
    double *HWY_RESTRICT geometry = out.geometry, *HWY_RESTRICT rotation = out.rotation;
    for (int c = 0; c < count; ++c) {
        const std::size_t i = std::size_t{4} * pi[c], j = std::size_t{4} * pj[c],
                          shift = std::size_t{4} * image[c];
        for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
            const auto difference = hn::Sub(hn::Load(d, a + j + k), hn::Load(d, a + i + k));
            hn::Store(hn::Add(difference, hn::Load(d, shifts + shift + k)), d, geometry + 4 * c + k);
            hn::Store(hn::MulAdd(hn::Load(d, kSign + k), hn::Load(d, b + i + k), hn::Load(d, b + j + k)), d,
                      rotation + 4 * c + k);
        }
    }
}

// N pairs side by side, as staged.
struct Lanes {
    V dx, dy, dvx, dvy, r_sum, rw_sum, dw, r_diff;
    Lanes(const Staging& st, int c) {
        hn::LoadInterleaved4(D(), st.geometry + 4 * c, dx, dy, dvx, dvy);
        hn::LoadInterleaved4(D(), st.rotation + 4 * c, r_sum, rw_sum, dw, r_diff);
    }
};

// Constants of the law in every lane.
struct LawLanes {
    V young, ratio_dt, rolling, friction, rolling_limit;
    bool total_rolling;
    LawLanes(const KernelConstants& k, double dt)
        : young(hn::Set(D(), 0.5 * k.young)),
          ratio_dt(hn::Set(D(), k.stiffness_ratio * dt)),
          rolling(hn::Set(D(), 0.25 * k.rolling_stiffness)),
          friction(hn::Set(D(), k.friction)),
          rolling_limit(hn::Set(D(), 0.5 * k.rolling_limit)),
          total_rolling(k.total_rolling) {}
};

// Step 3: normal, overlap and f_n = k_n max(overlap, 0); k_n = E 2 r_i r_j / (r_i + r_j) with
// 4 r_i r_j = (sum - diff)(sum + diff). One division serves 1/|d| and 1/(r_i + r_j).
struct Normal {
    V inv_dist, nx, ny, overlap, four_rr, kt_dt, fn;
    Normal(const Lanes& p, const LawLanes& k) {
        const D d;
        const V dist = hn::Sqrt(hn::MulAdd(p.dx, p.dx, hn::Mul(p.dy, p.dy)));
        const V q = hn::Div(hn::Set(d, 1.0), hn::Mul(dist, p.r_sum));
        inv_dist = hn::Mul(q, p.r_sum);
        nx = hn::Mul(p.dx, inv_dist), ny = hn::Mul(p.dy, inv_dist);
        overlap = hn::Sub(p.r_sum, dist);
        four_rr = hn::Mul(hn::Sub(p.r_sum, p.r_diff), hn::Add(p.r_sum, p.r_diff));
        const V kn = hn::Mul(k.young, hn::Mul(four_rr, hn::Mul(q, dist)));
        fn = hn::Mul(kn, hn::Max(overlap, hn::Zero(d)));
        kt_dt = hn::Mul(kn, k.ratio_dt);
    }
};

HWY_INLINE V Limited(V value, V limit) { return hn::Max(hn::Min(value, limit), hn::Neg(limit)); }

// Step 4: tangential force along e = (n_y, -n_x) with alpha_g = (r_i + r_j)/|d|, at most tan(phi) f_n.
HWY_INLINE V Tangential(const Lanes& p, const Normal& n, const LawLanes& k, double* history) {
    const D d;
    const V slip = hn::NegMulAdd(p.dvy, n.nx, hn::Mul(p.dvx, n.ny));
    const V vt = hn::MulAdd(hn::Mul(p.r_sum, n.inv_dist), slip, p.rw_sum);
    const V ft = Limited(hn::NegMulAdd(n.kt_dt, vt, hn::Load(d, history)), hn::Mul(n.fn, k.friction));
    hn::Store(ft, d, history);
    return ft;
}

// Step 5: rolling moment, at most eta min(r) f_n. Elastic-plastic increments remember the limited moment, the
// total form the whole -k_r theta.
HWY_INLINE V Rolling(const Lanes& p, const Normal& n, const LawLanes& k, double* history) {
    const D d;
    const V limit = hn::Mul(hn::Mul(k.rolling_limit, hn::Sub(p.r_sum, hn::Abs(p.r_diff))), n.fn);
    const V kr_dt = hn::Mul(hn::Mul(k.rolling, n.four_rr), n.kt_dt);
    const V rolled = hn::NegMulAdd(kr_dt, p.dw, hn::Load(d, history));
    const V m = Limited(rolled, limit);
    const V kept = hn::IfThenElseZero(hn::Gt(n.overlap, hn::Zero(d)), rolled);
    hn::Store(k.total_rolling ? kept : m, d, history);
    return m;
}

// The contact law on N lanes at once. Pairs that do not touch get f_n = 0, which also clears their history.
template <bool kStress>
HWY_INLINE void ContactLaw(const Arrays& s, const LawLanes& k, int first, int count, Staging& st, V* sum) {
    const D d;
    const V half = hn::Set(d, 0.5);
    for (int c = 0; c < count; c += static_cast<int>(hn::Lanes(d))) {
        const Lanes p(st, c);
        const Normal n(p, k);
        const V ft = Tangential(p, n, k, s.tangential + first + c),
                m = Rolling(p, n, k, s.moment + first + c);
        const V fx = hn::MulAdd(n.fn, n.nx, hn::Mul(ft, n.ny)),
                fy = hn::NegMulAdd(ft, n.nx, hn::Mul(n.fn, n.ny));
        // Step 6: n x f = -f_t, so the torques are +(r - overlap/2) f_t on both, -M on i and +M on j.
        const V arms = hn::Sub(p.r_sum, n.overlap);
        const V ti = hn::Sub(hn::Mul(hn::Mul(half, hn::Sub(arms, p.r_diff)), ft), m);
        const V tj = hn::MulAdd(hn::Mul(half, hn::Add(arms, p.r_diff)), ft, m);
        hn::StoreInterleaved4(fx, fy, ti, tj, d, st.force + 4 * c);
        if constexpr (kStress) {
            sum[0] = hn::MulAdd(p.dx, fx, sum[0]), sum[1] = hn::MulAdd(p.dx, fy, sum[1]);
            sum[2] = hn::MulAdd(p.dy, fx, sum[2]), sum[3] = hn::MulAdd(p.dy, fy, sum[3]);
        }
    }
}

// Pair by pair, so two pairs of one grain never conflict; the pair order keeps neighbours in time apart.
HWY_INLINE void Scatter(const Arrays& s, int first, int count, const Staging& st) {
    const D4 d;
    alignas(32) static constexpr double kOnI[4] = {-1, -1, 1, 0}, kOnJ[4] = {1, 1, 0, 1};
    const std::uint16_t *HWY_RESTRICT pi = s.i + first, *HWY_RESTRICT pj = s.j + first;
    double* force = s.force;
    for (int c = 0; c < count; ++c) {
        double *on_i = force + std::size_t{4} * pi[c], *on_j = force + std::size_t{4} * pj[c];
        for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
            const auto f = hn::Load(d, st.force + 4 * c + k);
            hn::Store(hn::MulAdd(f, hn::Load(d, kOnI + k), hn::Load(d, on_i + k)), d, on_i + k);
            hn::Store(hn::MulAdd(f, hn::Load(d, kOnJ + k), hn::Load(d, on_j + k)), d, on_j + k);
        }
    }
}

template <bool kStress>
HWY_INLINE void ForceLoop(FastState& s, const KernelConstants& k, double dt, V* sum) {
    std::fill(s.force.begin(), s.force.end(), 0.0);
    const ImageTable images(s);
    const Arrays arrays(s);
    const LawLanes law(k, dt);
    Staging staging;
    for (int first = 0; first < s.slots; first += kBlock) {
        const int count = std::min(kBlock, s.slots - first);
        Stage(arrays, images, first, count, staging);
        ContactLaw<kStress>(arrays, law, first, count, staging, sum);
        Scatter(arrays, first, count, staging);
    }
}

void ContactForces(FastState& s, const KernelConstants& k, double dt) { ForceLoop<false>(s, k, dt, nullptr); }

void ContactForcesAndStress(FastState& s, const KernelConstants& k, double dt, double* moment_sum) {
    const D d;
    V sum[4] = {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    ForceLoop<true>(s, k, dt, sum);
    for (int c = 0; c < 4; ++c) moment_sum[c] = hn::GetLane(hn::SumOfLanes(d, sum[c]));
}

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
