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

// The contact law on N lanes at once. Pairs that do not touch get f_n = 0, which also clears their history.
template <bool kStress>
HWY_INLINE void ContactLaw(const Arrays& s, const KernelConstants& k, double dt, int first, int count,
                           Staging& st, V* sum) {
    const D d;
    const V half = hn::Set(d, 0.5), zero = hn::Zero(d);
    const V young = hn::Set(d, 0.5 * k.young), ratio_dt = hn::Set(d, k.stiffness_ratio * dt);
    const V rolling_dt = hn::Set(d, 0.25 * k.rolling_stiffness), friction = hn::Set(d, k.friction);
    const V rolling_limit = hn::Set(d, 0.5 * k.rolling_limit);
    for (int c = 0; c < count; c += static_cast<int>(hn::Lanes(d))) {
        V dx, dy, dvx, dvy, r_sum, rw_sum, dw, r_diff;
        hn::LoadInterleaved4(d, st.geometry + 4 * c, dx, dy, dvx, dvy);
        hn::LoadInterleaved4(d, st.rotation + 4 * c, r_sum, rw_sum, dw, r_diff);
        const V dist = hn::Sqrt(hn::MulAdd(dx, dx, hn::Mul(dy, dy)));
        // One division serves 1/|d| and 1/(r_i + r_j).
        const V q = hn::Div(hn::Set(d, 1.0), hn::Mul(dist, r_sum));
        const V inv_dist = hn::Mul(q, r_sum);
        const V nx = hn::Mul(dx, inv_dist), ny = hn::Mul(dy, inv_dist);
        const V overlap = hn::Sub(r_sum, dist);
        // k_n = E 2 r_i r_j / (r_i + r_j), with 4 r_i r_j = (sum - diff)(sum + diff).
        const V four_rr = hn::Mul(hn::Sub(r_sum, r_diff), hn::Add(r_sum, r_diff));
        const V kn = hn::Mul(young, hn::Mul(four_rr, hn::Mul(q, dist)));
        const V fn = hn::Mul(kn, hn::Max(overlap, zero));
        const V kt_dt = hn::Mul(kn, ratio_dt);
        // v_rel along e = (n_y, -n_x); alpha_g = (r_i + r_j)/|d|.
        const V slip = hn::NegMulAdd(dvy, nx, hn::Mul(dvx, ny));
        const V vt = hn::MulAdd(hn::Mul(r_sum, inv_dist), slip, rw_sum);
        const V ft_limit = hn::Mul(fn, friction);
        V ft = hn::NegMulAdd(kt_dt, vt, hn::Load(d, s.tangential + first + c));
        ft = hn::Max(hn::Min(ft, ft_limit), hn::Neg(ft_limit));
        hn::Store(ft, d, s.tangential + first + c);
        // Rolling moment, limit eta min(r) f_n. Elastic-plastic increments remember the limited moment, the
        // total form the whole -k_r theta.
        const V m_limit = hn::Mul(hn::Mul(rolling_limit, hn::Sub(r_sum, hn::Abs(r_diff))), fn);
        const V kr_dt = hn::Mul(hn::Mul(rolling_dt, four_rr), kt_dt);
        const V rolled = hn::NegMulAdd(kr_dt, dw, hn::Load(d, s.moment + first + c));
        const V m = hn::Max(hn::Min(rolled, m_limit), hn::Neg(m_limit));
        hn::Store(k.total_rolling ? hn::IfThenElseZero(hn::Gt(overlap, zero), rolled) : m, d,
                  s.moment + first + c);
        const V fx = hn::MulAdd(fn, nx, hn::Mul(ft, ny)), fy = hn::NegMulAdd(ft, nx, hn::Mul(fn, ny));
        // n x f = -f_t, so both torques are +(r - overlap/2) f_t, and -+ M.
        const V arm_sum = hn::Sub(r_sum, overlap);
        const V ti = hn::NegMulAdd(m, hn::Set(d, 1.0), hn::Mul(hn::Mul(half, hn::Sub(arm_sum, r_diff)), ft));
        const V tj = hn::Add(m, hn::Mul(hn::Mul(half, hn::Add(arm_sum, r_diff)), ft));
        hn::StoreInterleaved4(fx, fy, ti, tj, d, st.force + 4 * c);
        if constexpr (kStress) {
            sum[0] = hn::MulAdd(dx, fx, sum[0]), sum[1] = hn::MulAdd(dx, fy, sum[1]);
            sum[2] = hn::MulAdd(dy, fx, sum[2]), sum[3] = hn::MulAdd(dy, fy, sum[3]);
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
    Staging staging;
    for (int first = 0; first < s.slots; first += kBlock) {
        const int count = std::min(kBlock, s.slots - first);
        Stage(arrays, images, first, count, staging);
        ContactLaw<kStress>(arrays, k, dt, first, count, staging, sum);
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
